"use strict";
// Tables of class "sortable": a press on a head sorts by its column; a field of class "filter" hides rows without its words.
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
  function sort(table, head) {
    const up = head.getAttribute("aria-sort") === "descending" || (!head.hasAttribute("aria-sort") && head.dataset.first === "up");
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
  for (const table of document.querySelectorAll("table.sortable")) {
    for (const head of table.tHead.querySelectorAll("th")) {
      const button = document.createElement("button");
      button.type = "button";
      button.className = "sort";
      button.append(...head.childNodes);
      head.append(button);
      button.addEventListener("click", function () { sort(table, head); });
    }
  }
  function filter(table) {
    const fields = document.querySelectorAll('[data-table="' + table.id + '"]');
    for (const row of table.tBodies[0].rows) {
      let shown = true;
      for (const field of fields) {
        const wanted = field.value.trim().toLowerCase();
        const column = field.dataset.column;
        const told = column === undefined ? row.textContent : row.cells[Number(column)].textContent;
        if (wanted && !told.toLowerCase().includes(wanted)) shown = false;
      }
      row.classList.toggle("filtered", !shown);
      row.hidden = !shown || row.classList.contains("unchosen");
    }
  }
  for (const field of document.querySelectorAll("[data-table]")) {
    const table = document.getElementById(field.dataset.table);
    field.addEventListener("input", function () { filter(table); });
  }
  for (const tools of document.querySelectorAll(".tools")) tools.hidden = false;
})();
