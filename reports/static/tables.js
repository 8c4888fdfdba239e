"use strict";
// Tables of class "sortable": a press on a head sorts by its column; a field of class "filter" hides rows without its words.
// Both are kept in the address: sort=<table>~<column>~up, find=<field>~<words>.
(function () {
  function key(row, place) {
    const cell = row.cells[place];
    if (!cell) return { none: true };
    const given = cell.dataset.v;
    if (given !== undefined) return { number: Number(given) };
    const text = cell.textContent.trim();
    return text === "–" || text === "" ? { none: true } : { text: text };
  }
  function compare(a, b) {
    if (a.none || b.none) return a.none ? (b.none ? 0 : Infinity) : -Infinity;
    if (a.number !== undefined && b.number !== undefined) return a.number - b.number;
    return String(a.text).localeCompare(String(b.text), "en", { numeric: true });
  }
  const tables = Array.from(document.querySelectorAll("table.sortable"));
  const fields = Array.from(document.querySelectorAll("[data-table]"));
  function nameOf(table) {
    return table.id || (table.caption ? table.caption.textContent.trim() : "") || String(tables.indexOf(table));
  }
  function press(table, head) {
    const up = head.getAttribute("aria-sort") === "descending" || (!head.hasAttribute("aria-sort") && head.dataset.first === "up");
    sort(table, head, up);
    const others = c4sAddress.all("sort").filter(function (told) { return !told.startsWith(nameOf(table) + "~"); });
    c4sAddress.put({ sort: others.concat([[nameOf(table), head.textContent.trim(), up ? "up" : "down"].join("~")]) });
  }
  function sort(table, head, up) {
    const place = Array.prototype.indexOf.call(head.parentNode.children, head);
    for (const other of head.parentNode.children) other.removeAttribute("aria-sort");
    head.setAttribute("aria-sort", up ? "ascending" : "descending");
    const body = table.tBodies[0];
    const rows = Array.from(body.rows, function (row) { return { row: row, key: key(row, place) }; });
    rows.sort(function (a, b) {
      const by = compare(a.key, b.key);
      return Math.abs(by) === Infinity ? (by > 0 ? 1 : -1) : up ? by : -by;
    });
    for (const one of rows) body.append(one.row);
  }
  for (const table of tables) {
    for (const head of table.tHead.querySelectorAll("th")) {
      const button = document.createElement("button");
      button.type = "button";
      button.className = "sort";
      button.append(...head.childNodes);
      head.append(button);
      button.addEventListener("click", function () { press(table, head); });
    }
  }
  function filter(table) {
    const own = fields.filter(function (field) { return field.dataset.table === table.id; });
    for (const row of table.tBodies[0].rows) {
      let shown = true;
      for (const field of own) {
        const wanted = field.value.trim().toLowerCase();
        const column = field.dataset.column;
        const told = column === undefined ? row.textContent : row.cells[Number(column)].textContent;
        if (wanted && !told.toLowerCase().includes(wanted)) shown = false;
      }
      row.classList.toggle("filtered", !shown);
      row.hidden = !shown || row.classList.contains("unchosen");
    }
  }
  function fieldName(field) { return field.dataset.table + "." + (field.dataset.column || ""); }
  for (const field of fields) {
    field.addEventListener("input", function () {
      filter(document.getElementById(field.dataset.table));
      c4sAddress.put({ find: fields.filter(function (one) { return one.value; }).map(function (one) { return fieldName(one) + "~" + one.value; }) });
    });
  }
  c4sAddress.follow(function () {
    for (const told of c4sAddress.all("sort")) {
      const way = told.slice(told.lastIndexOf("~") + 1);
      const table = tables.find(function (one) { return told.startsWith(nameOf(one) + "~"); });
      const title = table ? told.slice(nameOf(table).length + 1, -way.length - 1) : "";
      const head = table && Array.from(table.tHead.querySelectorAll("th")).find(function (one) { return one.textContent.trim() === title; });
      if (head) sort(table, head, way === "up");
    }
    const wanted = new Map(c4sAddress.all("find").map(function (told) { return [told.slice(0, told.indexOf("~")), told.slice(told.indexOf("~") + 1)]; }));
    for (const field of fields) field.value = wanted.get(fieldName(field)) || "";
    for (const table of new Set(fields.map(function (field) { return field.dataset.table; }))) filter(document.getElementById(table));
  });
  for (const tools of document.querySelectorAll(".tools")) tools.hidden = false;
})();
