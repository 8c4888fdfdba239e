"use strict";
// Two configurations case by case: the plane of their scores, the paired differences, every case. Both are in the address.
(function () {
  const place = document.getElementById("pair");
  if (!place) return;
  const first = document.getElementById("first");
  const second = document.getElementById("second");
  const titles = JSON.parse(place.dataset.settings);
  const SVG = "http://www.w3.org/2000/svg";
  const SIDE = 360;
  const EDGE = 40;

  function make(tag, given, ...inner) {
    const made = document.createElement(tag);
    for (const name in given) made.setAttribute(name, given[name]);
    made.append(...inner);
    return made;
  }
  function draw(tag, given, ...inner) {
    const made = document.createElementNS(SVG, tag);
    for (const name in given) made.setAttribute(name, given[name]);
    made.append(...inner);
    return made;
  }
  function fixed(value, digits) { return value === null || value === undefined ? "–" : value.toFixed(digits); }
  function short(name) { return name.length > 40 ? name.slice(0, 24) + "…" + name.slice(-14) : name; }
  function chance(p) { return p !== null && p !== undefined && p < 0.00005 ? "< 0.0001" : fixed(p, 4); }
  function signed(value, digits) {
    if (value === null || value === undefined) return "–";
    return (value > 0 ? "+" : value < 0 ? "−" : "") + Math.abs(value).toFixed(digits);
  }
  function across(score) { return EDGE + score * (SIDE - EDGE - 10); }
  function up(score) { return SIDE - EDGE - score * (SIDE - EDGE - 10); }

  function plane(rows, settings, a, b) {
    const svg = draw("svg", { viewBox: "0 0 " + SIDE + " " + SIDE, class: "cross", role: "group", "aria-label": "Scores of " + a + " and " + b + ", a dot a case" });
    svg.append(
      draw("rect", { class: "frame", x: across(0), y: up(1), width: across(1) - across(0), height: up(0) - up(1) }),
      draw("line", { class: "even", x1: across(0), y1: up(0), x2: across(1), y2: up(1) }),
      draw("text", { x: across(0.5), y: SIDE - 8, "text-anchor": "middle" }, short(a)),
      draw("text", { x: -up(0.5), y: 14, transform: "rotate(-90)", "text-anchor": "middle" }, short(b))
    );
    for (const end of [0, 1]) {
      svg.append(draw("text", { x: across(end), y: up(0) + 16, "text-anchor": "middle" }, String(end)));
      svg.append(draw("text", { x: across(0) - 6, y: up(end) + 4, "text-anchor": "end" }, String(end)));
    }
    for (const row of rows) {
      const dot = draw("circle", { cx: across(row.a).toFixed(1), cy: up(row.b).toFixed(1), r: 4, class: "s" + settings.indexOf(row.setting) });
      const link = draw("a", { href: place.dataset.root + row.link }, dot);
      link.prepend(draw("title", {}, row.id + ": " + fixed(row.a, 3) + ", " + fixed(row.b, 3)));
      svg.append(link);
    }
    const legend = make("ul", { class: "legend" });
    settings.forEach(function (setting, number) {
      const mark = draw("svg", { viewBox: "0 0 10 10", "aria-hidden": "true" }, draw("circle", { cx: 5, cy: 5, r: 5 }));
      legend.append(make("li", { class: "s" + number }, mark, titles[setting] || setting));
    });
    const above = rows.filter(function (row) { return row.a > row.b; }).length;
    const below = rows.filter(function (row) { return row.a < row.b; }).length;
    return make("div", {}, svg, legend, make("p", { class: "dim" }, a + " is better on " + above + " of " + rows.length + " cases, " + b + " on " + below + "."));
  }

  function bar(value, most) {
    const svg = draw("svg", { class: "delta", viewBox: "0 0 84 10", "aria-hidden": "true" });
    const size = most ? (Math.abs(value) / most) * 42 : 0;
    svg.append(draw("rect", { class: value > 0 ? "up" : "down", x: value > 0 ? 42 : 42 - size, y: 1, width: size, height: 8 }));
    svg.append(draw("line", { class: "zero", x1: 42, x2: 42, y1: 0, y2: 10 }));
    return svg;
  }

  function cells(tag, values, scope) {
    return values.map(function (value, number) {
      const cell = make(number ? tag : "th", number ? { class: "r" } : { scope: scope });
      cell.append(...(Array.isArray(value) ? value : [value]));
      return cell;
    });
  }

  function table(caption, heads, rows) {
    const head = make("thead", {}, make("tr", {}, ...heads.map(function (title, number) { return make("th", number ? { scope: "col", class: "r" } : { scope: "col" }, title); })));
    const body = make("tbody", {}, ...rows.map(function (row) { return make("tr", {}, ...cells("td", row, "row")); }));
    return make("table", {}, make("caption", { class: "quiet" }, caption), head, body);
  }

  function parts(found, turned) {
    const sign = turned ? -1 : 1;
    function flip(value) { return value === null ? null : sign * value; }
    return table(
      "Paired differences in points, the first less the second" + (found.parts[0].score_low === null ? "; too few source scenes for an interval" : ", with 95 % intervals by source scenes"),
      ["Cases of", "Cases", "Δ score", "p"],
      found.parts.map(function (part) {
        const ends = [flip(part.score_low), flip(part.score_high)].sort(function (a, b) { return a - b; });
        const told = [signed(flip(part.score), 2)];
        if (part.score_low !== null) told.push(make("small", { class: "ends" }, signed(ends[0], 2) + " to " + signed(ends[1], 2)));
        return [part.cases_of, String(part.cases), told, chance(part.score_p)];
      })
    );
  }

  function show(data) {
    const a = first.value;
    const b = second.value;
    const ia = data.order.indexOf(a);
    const ib = data.order.indexOf(b);
    const rows = data.cases
      .map(function (one) { return { id: one.id, link: one.link, setting: one.setting, a: one.scores[ia], b: one.scores[ib] }; })
      .filter(function (row) { return row.a !== null && row.b !== null; });
    const settings = Array.from(new Set(data.cases.map(function (one) { return one.setting; })));
    rows.sort(function (one, other) { return other.a - other.b - (one.a - one.b); });
    const found = data.pairs.find(function (pair) { return (pair.a === a && pair.b === b) || (pair.a === b && pair.b === a); });
    const side = make("div", {});
    if (a === b) side.append(make("p", { class: "dim" }, "Choose two different configurations."));
    else if (found) {
      side.append(make("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": "Paired differences" }, parts(found, found.a === b)));
      side.append(make("p", { class: "source" }, "Get it again: c4s analyze paired -a " + found.a + " -a " + found.b + ", answer " + found.id));
    } else if (data.whole.includes(a) && data.whole.includes(b)) {
      side.append(make("p", { class: "source" }, "Not among the pairs that are told here. Their difference: c4s analyze paired -a " + a + " -a " + b));
    } else side.append(make("p", { class: "dim" }, "One of the two lacks outcomes: cases that both have are shown, no difference is told."));
    const most = Math.max(0, ...rows.map(function (row) { return Math.abs(row.a - row.b); }));
    const list = table("Cases, where the first is better on top", ["Case", short(a), short(b), "Δ points"], rows.map(function (row) {
      const link = make("a", { href: place.dataset.root + row.link }, row.id);
      return [[link], fixed(row.a, 3), fixed(row.b, 3), [signed(100 * (row.a - row.b), 1), bar(row.a - row.b, most)]];
    }));
    side.append(make("div", { class: "scroll pair-cases", tabindex: "0", role: "region", "aria-label": "Cases of both" }, list));
    place.replaceChildren(plane(rows, settings, a, b), side);
  }

  c4s.when("compare", function (data) {
    function read() {
      const [a, b] = [c4sAddress.get("a"), c4sAddress.get("b")];
      first.value = data.order.includes(a) ? a : data.order[0] || "";
      second.value = data.order.includes(b) ? b : data.order.find(function (name) { return name !== first.value; }) || first.value;
      show(data);
    }
    function keep() {
      c4sAddress.put({ a: first.value, b: second.value });
      show(data);
    }
    first.addEventListener("change", keep);
    second.addEventListener("change", keep);
    document.getElementById("swap").addEventListener("click", function () {
      [first.value, second.value] = [second.value, first.value];
      keep();
    });
    if (data.order.length) c4sAddress.follow(read);
  });
})();
