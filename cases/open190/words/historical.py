"""Prompts of historical places."""

from __future__ import annotations

WORDS = {
    "market-town": """
    It is {id|market day in a small medieval town}, and {density|the square is packed}. {square under stalls|[# market_stalls|*Stall|stalls] in
    striped and plain cloth stand back to back on worn [cobbles|CobblePavement|square]}, {stalls grid|a neat block of rows that sells
    [pottery|PotteryStall], [spices|SpiceStall], [books|BookStall] and [bread|BreadStall]}. {houses around stalls|[# town_houses|/house|houses]
    close the square on every side}, {houses material|in brick or plaster}, {houses color|red, pink and cream}, {houses attribute|roofed with
    tile or thatch}. {chapel near houses|A [small granite chapel|Chapel] hides among them}.

    {well near stalls|Beside the market people draw water from [a deep granite well|DrawWell]}; {benches around well; benches
    ring|[# plain benches|Bench] stand in a ring round it}, and {mayor near well|[a bronze statue|FigureStatue|mayor] of a forgotten mayor looks
    on}. {poles row|[# banner_poles|BannerPole|poles] in a line mark the southern edge}. {layout|Everywhere between lie} [barrels|Barrel],
    [sacks of coal|CoalSack|sacks], [wicker baskets|Basket], [pine chests|Chest] and [# handcarts|Handcart]. {animals scattered|[# loose
    animals|/animal] wander about}, among them [# white horses|Horse], [# goats|Goat] and [# brown hens|Hen].

    {trees scattered|To the north [~ broad trees|/tree], {trees attribute|oaks, limes and ashes}, form an irregular wood} {bushes near trees|with
    [# clipped bushes|Bush:Clipped|bushes] and [boulders|Boulder] beneath}. {wheat rows; wheat on furrows|To the south [ripe wheat|WheatRow]
    grows in straight rows on [brown furrows|FurrowsGround]}, {layout|and a cobbled road leads out between the fields}.
    """
}
