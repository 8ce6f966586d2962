"use strict";
// What a reader does on the report, done by a script at the end of the page: points at charts, zooms,
// switches models, chooses, sorts. Every event goes to whatever lies on top at its place, as a mouse's
// would. What the page then shows is written into #actions, which fresnel_report_test.cpp reads.
(async () => {
  const seen = {};
  const $ = selector => document.querySelector(selector);
  const texts = selector => Array.from(document.querySelectorAll(selector), e => e.textContent);
  const pause = ms => new Promise(resolve => setTimeout(resolve, ms));

  // The place at these parts of an element's width and height, and what lies there.
  function spot(element, across, down) {
    element.scrollIntoView({ block: "center", behavior: "instant" });
    const box = element.getBoundingClientRect();
    const clientX = box.left + across * box.width, clientY = box.top + down * box.height;
    return { clientX, clientY, top: document.elementFromPoint(clientX, clientY) };
  }
  function mouse(type, { clientX, clientY, top }, more = {}) {
    const init = { bubbles: true, cancelable: true, view: window, clientX, clientY, ...more };
    top.dispatchEvent(type === "wheel" ? new WheelEvent(type, init) : new MouseEvent(type, init));
  }
  const tip = () => ($("#tip").style.display === "none" ? "" : $("#tip").textContent);
  const surface = chart => $(chart + " svg > g > rect");
  const ticks = chart => texts(chart + " .axis .tick text");
  const lines = chart => document.querySelectorAll(chart + " path.line").length;
  const pressed = () => texts("#legend button.model[aria-pressed=true]");
  const legend = name => Array.from(document.querySelectorAll("#legend button.model")).find(b => b.textContent === name);

  mouse("mousemove", spot(surface("#over-angle"), 60 / 89, 0.5));
  seen.hover = tip();
  mouse("mouseleave", spot(surface("#over-angle"), 0.5, 0.5));
  seen.left = tip();
  const map = spot($("#maps canvas"), 0.5, 0.01);
  mouse("mousemove", map);
  seen.map = tip();
  mouse("mouseleave", map);
  const mark = Array.from(document.querySelectorAll("#front circle")).find(c => c.getAttribute("r") === "7");
  mouse("mousemove", spot(mark, 0.5, 0.5));
  seen.mark = tip();

  seen.ticks = ticks("#over-angle");
  mouse("wheel", spot(surface("#over-angle"), 0.9, 0.5), { deltaY: -240 });
  seen.wheel_alone = ticks("#over-angle");
  mouse("wheel", spot(surface("#over-angle"), 0.9, 0.5), { deltaY: -240, ctrlKey: true });
  seen.zoomed = ticks("#over-angle");
  const from = spot(surface("#over-angle"), 0.5, 0.5);
  mouse("mousedown", from);
  mouse("mousemove", { ...from, clientX: from.clientX + 60 });
  mouse("mouseup", { ...from, clientX: from.clientX + 60 });
  seen.dragged = ticks("#over-angle");
  await pause(50);  // a click right after a drag belongs to the drag
  const reset = $("#over-angle button.reset");
  seen.reset_offered = getComputedStyle(reset).display !== "none";
  spot(reset, 0.5, 0.5).top.click();
  seen.whole = ticks("#over-angle");
  mouse("dblclick", spot(surface("#over-angle"), 0.5, 0.5));
  seen.double_click = ticks("#over-angle");
  reset.click();

  seen.lines = lines("#over-angle");
  spot(legend("schlick"), 0.5, 0.5).top.closest("button").click();
  seen.without_schlick = { lines: lines("#over-angle"), pressed: pressed(), rows: texts("#statistics tbody tr td:first-child") };
  mouse("dblclick", spot(legend("schlick"), 0.5, 0.5));
  seen.schlick_alone = pressed();
  Array.from(document.querySelectorAll("#legend button.plain")).find(b => b.textContent === "all").click();
  seen.all = pressed();

  const choose = (select, value) => { select.value = value; select.dispatchEvent(new Event("change", { bubbles: true })); };
  const titles = () => texts("#over-angle h3, #delta-e h3");
  const [material, light] = document.querySelectorAll("#reflectance-controls select");
  choose(material, "1");
  seen.other_material = titles();
  choose(light, "p");
  seen.p_polarised = { titles: titles(), lines: lines("#over-angle") };
  const slider = $("#reflectance-controls input[type=range]");
  slider.value = 0;
  slider.dispatchEvent(new Event("input", { bubbles: true }));
  seen.first_wavelength = titles();
  const costs = () => texts("#cost-table tbody td:first-child");
  seen.costs = costs();
  const head = Array.from(document.querySelectorAll("#cost-table th")).find(h => h.textContent === "relative");
  head.click();
  head.click();
  seen.costs_sorted_down = costs();

  const record = document.createElement("pre");
  record.id = "actions";
  record.textContent = JSON.stringify(seen);
  document.body.append(record);
})();
