"""Parts of places that many scenes share; each lies in the frame of the place (``at``), its middle at the origin."""
