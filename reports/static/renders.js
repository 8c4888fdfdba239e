"use strict";
// Two renders of one camera over each other with a slider between them, made of the table of renders.
// What is compared, from which camera and where the slider stands is kept in the address.
(function () {
  function choice(label, names, chosen) {
    var wrap = document.createElement("label"), select = document.createElement("select");
    names.forEach(function (name) {
      var option = document.createElement("option");
      option.textContent = name;
      option.value = name;
      option.selected = name === chosen;
      select.append(option);
    });
    wrap.append(label + " ", select);
    return { wrap: wrap, select: select };
  }

  function slider(table, into) {
    var rows = {}, views = [], order = [];
    table.querySelectorAll("tbody tr").forEach(function (row) {
      var found = {};
      row.querySelectorAll("td img").forEach(function (image) {
        var view = image.closest("td").dataset.view;
        found[view] = image;
        if (views.indexOf(view) < 0) { views.push(view); }
      });
      rows[row.dataset.row] = found;
      order.push(row.dataset.row);
    });
    if (order.length < 2 || !views.length) { return; }
    var last = order[order.length - 1];
    var run = table.querySelector("tr[data-run]");
    var first = table.querySelector("tr[data-truth]");
    var left = choice("Left", order, first ? first.dataset.row : order[0]);
    var right = choice("Right", order, run ? run.dataset.row : last);
    var view = choice("Camera", views, views[0]);
    var range = document.createElement("input");
    range.type = "range"; range.min = "0"; range.max = "100"; range.value = "50";
    range.setAttribute("aria-label", "How much of the left picture is seen");
    var stage = document.createElement("div"), under = document.createElement("img"), over = document.createElement("img");
    stage.className = "stage";
    over.className = "over";
    var line = document.createElement("span");
    line.className = "line";
    stage.append(under, over, line);
    var told = document.createElement("p");
    told.className = "dim";
    told.setAttribute("aria-live", "polite");

    function put(image, from, label) {
      image.hidden = !from;
      if (!from) { return; }
      if (image.src !== from.src) { image.src = from.src; }
      image.alt = label + ", " + view.select.value;
      image.width = from.width; image.height = from.height;
    }
    function draw() {
      var at = view.select.value, one = rows[left.select.value][at], two = rows[right.select.value][at];
      put(over, one, left.select.value);
      put(under, two, right.select.value);
      stage.style.setProperty("--cut", range.value + "%");
      told.textContent = one && two ? left.select.value + " | " + right.select.value
        : (one ? right.select.value : left.select.value) + " has no picture from this camera";
    }
    var set = { left: left.select, right: right.select, camera: view.select, cut: range };
    function keep() {
      var told = {};
      for (var name in set) { told[name] = set[name].value; }
      c4sAddress.put(told);
    }
    [left.select, right.select, view.select].forEach(function (select) {
      select.addEventListener("change", function () { draw(); keep(); });
    });
    range.addEventListener("input", draw);
    range.addEventListener("change", keep);
    function drag(event) {
      var box = stage.getBoundingClientRect();
      range.value = String(Math.round(100 * (event.clientX - box.left) / box.width));
      draw();
    }
    stage.addEventListener("pointerdown", function (event) { event.preventDefault(); stage.setPointerCapture(event.pointerId); drag(event); });
    stage.addEventListener("pointerup", keep);
    stage.addEventListener("pointermove", function (event) { if (event.buttons) { drag(event); } });

    var controls = document.createElement("div");
    controls.className = "controls";
    controls.append(left.wrap, right.wrap, view.wrap);
    var box = document.createElement("div");
    box.className = "compare";
    box.append(controls, stage, range, told);
    into.insertBefore(box, into.querySelector(".scroll"));
    c4sAddress.follow(function () {
      for (var name in set) {
        var wanted = c4sAddress.get(name), field = set[name];
        if (wanted === null) { continue; }
        if (!field.options || Array.from(field.options).some(function (one) { return one.value === wanted; })) { field.value = wanted; }
      }
      draw();
    });
  }

  document.querySelectorAll("[data-renders]").forEach(function (place) { slider(place.querySelector("table"), place); });
})();
