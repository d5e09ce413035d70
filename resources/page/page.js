// What is shown, and how the reader moves it. Keys: Left and Right, Home and End, Space plays, PageUp and PageDown turn
// the slides, Shift and an arrow move the chosen pixel, Escape closes its card. After a # in the page's address: step=N,
// slide=N, pixel=X,Y, lang=en|zh, answered and state, with & between.
const byId = id => document.getElementById(id);
const data = JSON.parse(byId("data").textContent);
const runs = []; // those of the data, once their pictures are unpacked
const shown = {
  run: null,
  pixel: null,     // [x, y]
  marks: lesson.marks,
  compares: false, // the other picture is shown
  zooms: true,     // of a large picture only the part about the step is shown
  timer: 0,        // plays
};
const kStepsASecond = 6;

function showStep() {
  const run = shown.run;
  const event = run.event;
  const words = event ? run.steps[run.position - 1] : null;
  const isStillPicture = run.isStill && !event;
  byId("step").hidden = isStillPicture;
  byId("step-title").textContent = words ? textOf(words.title) : run.size === 0 ? say("noEvents") : say("start");
  byId("sentence").textContent = words ? textOf(words.sentence) : run.size === 0 ? "" : say("startSentence");
  byId("formula").textContent = words ? textOf(words.formula).replace(/ {3,}/g, "\n") : ""; // parts stand in lines
  const code = byId("code");
  code.replaceChildren();
  for (const [i, [line, right]] of (words ? data.codes[words.code] : []).entries()) {
    const item = document.createElement("li");
    item.className = i === words.line ? "now" : "";
    const text = document.createElement("span");
    text.textContent = textOf(line);
    if (textOf(right) !== "" && !lesson.asksForMistake) { // a mistake is in its place
      text.className = "wrong";
      const struck = document.createElement("s");
      struck.textContent = textOf(right);
      item.append(struck);
    }
    item.append(text);
    code.append(item);
  }
}

function showRemarks() {
  const run = shown.run;
  const lines = [];
  if (run.empty !== undefined)
    lines.push(textOf(run.empty));
  if (run.limit !== undefined)
    lines.push(say("limit", run.limit));
  if (run.filter && run.filter.face !== undefined)
    lines.push(say("onlyFace", run.filter.face));
  if (run.filter && run.filter.pixel)
    lines.push(say("onlyPixel", ...run.filter.pixel));
  if (run.isStill)
    lines.push(say(run.event ? "stillStep" : "still"));
  if (run.mistakes.length > 0 && !lesson.asksForMistake)
    lines.push(say("mistakeOn", run.mistakes.map(textOf).join(", ")));
  byId("remark").textContent = lines.join(" ");
  byId("remark").hidden = lines.length === 0;
}

function cell(row, content, className = "") {
  const made = row.insertCell();
  made.className = className;
  made.append(content);
  return made;
}

// The lens: every edge function at the sample with its sign, and who owns the points on the edge.
function showLens() {
  const run = shown.run;
  const test = run.event ? run.testOf(run.position - 1) : -1;
  byId("lens").hidden = !run.hasSamples;
  byId("lens-row").hidden = test < 0;
  byId("lens-edges").replaceChildren();
  byId("lens").firstElementChild.textContent = say(test < 0 ? "noSample" : "lens");
  byId("lens").firstElementChild.className = test < 0 ? "muted" : "";
  if (test < 0)
    return;
  const event = run.events[test];
  const setup = run.events[run.setupOf[test]];
  event.edges.forEach((name, i) => {
    const row = byId("lens-edges").insertRow();
    const line = document.createElement("span");
    line.className = "line";
    line.style.borderTopStyle = ["solid", "dashed", "dotted"][i];
    line.style.borderTopColor = `var(--edge-${i})`;
    cell(row, line).append(name);
    cell(row, areaText(event.values[i], setup.units_per_sample ** 2));
    const glyph = document.createElement("span");
    const value = event.values[i];
    glyph.className = "glyph " + (value > 0 ? "plus" : value < 0 ? "minus" : "zero");
    glyph.textContent = value > 0 ? "+" : value < 0 ? "\u2212" : "0";
    cell(row, glyph);
    cell(row, say(setup.edges[i].side));
  });
  const kShort = 9; // characters that have room beside the drawing
  const texts = event.values.map(value => areaText(value, setup.units_per_sample ** 2));
  byId("lens-row").className = texts.some(text => text.length > kShort) ? "long" : "";
  drawLens(run, test);
}

function showCounters() {
  const list = byId("counters");
  list.replaceChildren();
  byId("numbers").hidden = shown.run.counts.length === 0;
  const counts = shown.run.position > 0 ? shown.run.counts[shown.run.position - 1] || [] : [];
  ["tested", "covered", "passed", "failed", "written", "twice"].forEach((key, i) => {
    const pair = document.createElement("div");
    const name = document.createElement("dt");
    const value = document.createElement("dd");
    name.textContent = say(key);
    value.textContent = counts[i] || 0;
    pair.append(name, value);
    list.append(pair);
  });
}

function element(tag, className, text) {
  const made = document.createElement(tag);
  made.className = className;
  made.textContent = text;
  return made;
}

function swatch(color) {
  const made = element("span", "swatch", "");
  made.style.background = color;
  return made;
}

// The card: what the chosen pixel stores, every face that could concern it, and its steps.
function showCard() {
  const rows = byId("card-rows");
  rows.replaceChildren();
  const isSecret = lesson.marksPixels || (shown.pixel && lesson.isSecret(...shown.pixel));
  const pixel = isSecret ? null : shown.pixel; // the card would answer the question
  byId("card-title").textContent = pixel ? say("cardTitle", ...pixel) : say("cardEmpty");
  byId("card-hint").textContent = pixel ? "" : say("cardHint");
  byId("card").className = pixel ? "chosen" : "";
  byId("close-card").hidden = !pixel;
  if (!pixel)
    return;
  const run = shown.run;
  const stored = pixelAt(...pixel);
  const depth = typeof stored.depth === "number" ? Number(stored.depth.toPrecision(9)) : stored.depth; // a float
  const storedRow = element("div", "row", "");
  storedRow.append(swatch(stored.color), depth === null ? say("storedColor", stored.color)
                                                               : say("stored", stored.color, depth));
  rows.append(storedRow);
  const card = run.cards[pixel.join(",")];
  if (card)
    showFaces(rows, card);
  else
    rows.append(element("div", "row muted", say("noCard")));
  showEventsHere(rows, run.eventsAt(...pixel));
}

function showFaces(rows, card) {
  rows.append(element("div", "row", say("finished", textOf(card.answer))));
  for (const line of card.samples)
    rows.append(element("div", "numbers", textOf(line)));
  if (card.faces.length === 0)
    rows.append(element("div", "row muted", say("noFace")));
  for (const face of card.faces) {
    const row = element("div", "row", "");
    row.append(element("span", "pill", textOf(face.name)), element("span", face.seen ? "right" : "wrong", textOf(face.verdict)));
    row.append(element("div", "numbers", face.details.map(textOf).join("\n")));
    rows.append(row);
  }
}

function showEventsHere(rows, events) {
  const kMost = 40;
  if (events.length === 0)
    return;
  const box = element("div", "row", say("eventsHere"));
  for (const i of events.slice(0, kMost)) {
    const jump = button(`${shown.run.first + i + 1}  ${textOf(shown.run.steps[i].title)}`, () => goTo(i + 1));
    jump.disabled = i + 1 === shown.run.position;
    box.append(jump);
  }
  if (events.length > kMost)
    box.append(say("moreEvents", events.length - kMost));
  rows.append(box);
}

// Marks on the track: where a face begins, and where a sample lies exactly on an edge.
function drawPips() {
  const run = shown.run;
  const canvas = byId("pips");
  const width = byId("track").clientWidth;
  const pen = fitCanvas(canvas, width, 10);
  canvas.style.width = "100%";
  const kThumb = 16; // the slider's thumb keeps within the track
  const style = getComputedStyle(document.documentElement);
  run.events.forEach((event, i) => {
    const isFace = event.event === "vertex" && event.corner === 0;
    if (!isFace && !event.tie)
      return;
    const x = kThumb / 2 + (width - kThumb) * (i + 1) / run.size;
    pen.fillStyle = style.getPropertyValue(isFace ? "--muted" : "--minus");
    pen.fillRect(x - 1, isFace ? 0 : 4, 2, isFace ? 10 : 6);
  });
}

function showTransport() {
  const run = shown.run;
  const scrubber = byId("scrubber");
  scrubber.max = run.size;
  scrubber.value = run.position;
  scrubber.disabled = run.size === 0 || run.isStill;
  byId("play").textContent = say(shown.timer ? "pause" : "play");
  for (const id of ["first", "step-back"])
    byId(id).disabled = run.position === 0 || run.isStill;
  for (const id of ["last", "step-on"])
    byId(id).disabled = run.position === run.size;
  byId("play").disabled = run.size === 0 || run.isStill;
  // As the window counts: step N is the moment after N events.
  const last = run.first + run.size;
  byId("counter").textContent = run.isStill ? (run.event ? say("oneStep", run.number + 1) : say("counterStill"))
    : run.size === 0 ? say("counterNone")
    : run.position === 0 ? say("counterStart", last) : say("counter", run.number + 1, last);
  scrubber.setAttribute("aria-valuetext", byId("counter").textContent);
  drawPips();
}

function showLegend() {
  const run = shown.run;
  const legend = byId("legend");
  legend.replaceChildren();
  if (!run.hasSamples)
    return;
  const parts = say("legendSigns").split(/[;；]\s*/);
  ["plus", "minus", "zero"].forEach((sign, i) => {
    legend.append(element("span", "glyph " + sign, "+\u22120"[i]), ` ${parts[i]}   `);
  });
}

function showOther() {
  const run = shown.run;
  const toggle = byId("compare");
  toggle.hidden = !run.other;
  if (!run.other)
    shown.compares = false;
  const isMistake = run.mistakes.length > 0;
  toggle.textContent = say(isMistake ? (shown.compares ? "withMistake" : "withoutMistake")
                                     : (shown.compares ? "thisPicture" : "otherPicture"));
}

function showTexts() {
  document.documentElement.lang = language === 1 ? "zh-CN" : "en";
  byId("language").textContent = say("language");
  for (const part of document.querySelectorAll("[data-say]"))
    part.textContent = say(part.dataset.say);
  const names = { first: "first", "step-back": "back", "step-on": "on", last: "last", scrubber: "scrubber", picture: "picture",
                  "close-card": "closeCard" };
  for (const [id, key] of Object.entries(names)) {
    byId(id).setAttribute("aria-label", say(key));
    byId(id).title = id === "picture" ? "" : say(key);
  }
  document.title = textOf(shown.run.scene) + " \u2013 RasterLens";
  byId("title").textContent = textOf(shown.run.scene);
  byId("note").textContent = lesson.slides.length > 0 && lesson.phase !== "free" ? "" : textOf(shown.run.note);
  byId("note").hidden = byId("note").textContent === "";
}

function showAll() {
  showTexts();
  showLesson();
  showOther();
  showRemarks();
  showStep();
  showLens();
  showCard();
  showCounters();
  showLegend();
  showTransport();
  drawPicture(shown.run, shown);
  byId("zoom").hidden = !view.isLarge;
  byId("zoom").textContent = say(shown.zooms ? "zoomOut" : "zoomIn");
  writeState();
}

// What is shown, for programs that read the page: with &state in its address, as JSON in the element "state".
function writeState() {
  if (!location.hash.includes("state"))
    return;
  const run = shown.run;
  const pixels = [];
  for (let y = 0; y < run.height; ++y)
    for (let x = 0; x < run.width; ++x)
      pixels.push(pixelAt(x, y));
  byId("state").textContent = JSON.stringify({
    events: runs[0].size, step: run.number, event: run.event, pixels, slide: lesson.slide + 1, phase: lesson.phase,
    title: byId("step-title").textContent, sentence: byId("sentence").textContent, formula: byId("formula").textContent,
    card: byId("card-rows").innerText, lens: byId("lens-edges").innerText, lesson: byId("lesson").innerText,
    remark: byId("remark").textContent, lang: document.documentElement.lang,
    width: document.documentElement.scrollWidth,
  });
}

// The colour and the depth that a pixel stores at the present step; depth null: the page does not know it.
function pixelAt(x, y) {
  const run = shown.run;
  return { color: colorText(run.pixelColor(x, y)), depth: run.pixelDepth(x, y) };
}

function goTo(position) {
  shown.run.moveTo(position);
  shown.compares = false;
  if (shown.run.position === shown.run.size)
    stopPlaying();
  showAll();
}

function showRun(run) {
  stopPlaying();
  shown.run = run;
  if (shown.pixel && (shown.pixel[0] >= run.width || shown.pixel[1] >= run.height))
    shown.pixel = null;
}

// Shows the moment of a slide: its run, the place in it, the pixel.
function showMoment(moment) {
  showRun(runs[moment.run]);
  shown.pixel = moment.pixel || null;
  goTo(positionOfMoment(moment));
}

function positionOfMoment(moment) {
  const run = runs[moment.run];
  return moment.step === undefined ? run.size : run.positionOf(moment.step);
}

function isAtMoment(moment) {
  return shown.run === runs[moment.run] && shown.run.position === positionOfMoment(moment);
}

function stopPlaying() {
  clearInterval(shown.timer);
  shown.timer = 0;
}

function togglePlaying() {
  if (shown.timer) {
    stopPlaying();
  } else {
    if (shown.run.position === shown.run.size)
      shown.run.moveTo(0);
    shown.timer = setInterval(() => goTo(shown.run.position + 1), 1000 / kStepsASecond);
  }
  showAll();
}

function choosePixel(x, y) {
  const run = shown.run;
  shown.pixel = [Math.max(0, Math.min(run.width - 1, x)), Math.max(0, Math.min(run.height - 1, y))];
  showAll();
}

function closeCard() {
  shown.pixel = null;
  showAll();
}

function toggleMark() {
  const mark = shown.pixel[1] * shown.run.width + shown.pixel[0];
  if (!lesson.marks.delete(mark))
    lesson.marks.add(mark);
  showAll();
}

// A tap or click chooses a pixel, and marks it where the question asks for pixels; a swipe steps.
function listenToPicture() {
  const canvas = byId("picture");
  let from = null;
  canvas.addEventListener("pointerdown", event => { from = event; });
  canvas.addEventListener("pointerup", event => {
    const kSwipe = 30;
    const dx = from ? event.clientX - from.clientX : 0;
    from = null;
    if (event.pointerType !== "mouse" && Math.abs(dx) > kSwipe) {
      goTo(shown.run.position + (dx < 0 ? 1 : -1));
      return;
    }
    const box = canvas.getBoundingClientRect();
    choosePixel(Math.floor((event.clientX - box.left - kMargin) / view.side) + view.left,
                Math.floor((event.clientY - box.top - kMargin) / view.side) + view.top);
    if (lesson.marksPixels)
      toggleMark();
  });
}

const kPixelMoves = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

function listenToKeys() {
  const actions = {
    ArrowLeft: () => goTo(shown.run.position - 1),
    ArrowRight: () => goTo(shown.run.position + 1),
    Home: () => goTo(0),
    End: () => goTo(shown.run.size),
    " ": togglePlaying,
    Escape: closeCard,
    PageDown: () => lesson.slides.length > 0 && lesson.next(),
    PageUp: () => lesson.slides.length > 0 && lesson.previous(),
  };
  document.addEventListener("keydown", event => {
    if (event.ctrlKey || event.altKey || event.metaKey)
      return;
    const onButton = event.target.tagName === "BUTTON" || event.target.type === "checkbox";
    const move = event.shiftKey ? kPixelMoves[event.key] : undefined;
    let action = move ? () => choosePixel(...(shown.pixel ? shown.pixel.map((at, i) => at + move[i]) : [0, 0]))
      : actions[event.key];
    if (event.key === " " && onButton)
      return;
    if (event.key === "Enter" && event.target === byId("picture") && shown.pixel && lesson.marksPixels)
      action = toggleMark;
    if (!action)
      return;
    event.preventDefault();
    action();
  });
}

function listenToButtons() {
  const actions = {
    first: () => goTo(0),
    "step-back": () => goTo(shown.run.position - 1),
    "step-on": () => goTo(shown.run.position + 1),
    last: () => goTo(shown.run.size),
    play: togglePlaying,
    "close-card": closeCard,
    language: () => { language = 1 - language; showAll(); },
    zoom: () => { shown.zooms = !shown.zooms; showAll(); },
    compare: () => { shown.compares = !shown.compares; showAll(); },
    previous: () => lesson.previous(),
    next: () => lesson.next(),
    back: () => showMoment(lesson.moment),
    free: toggleFree,
  };
  for (const [id, action] of Object.entries(actions))
    byId(id).addEventListener("click", action);
  byId("scrubber").addEventListener("input", event => goTo(Number(event.target.value)));
  byId("second-look").addEventListener("change", event => {
    lesson.secondLook = event.target.checked;
    showAll();
  });
  window.addEventListener("resize", showAll);
  window.addEventListener("hashchange", readAddress);
}

// Leaves the slides for all steps of the scene, or comes back to them.
function toggleFree() {
  if (lesson.phase === "free") {
    lesson.goTo(lesson.slide);
    return;
  }
  lesson.phase = "free";
  showRun(runs[0]);
  goTo(0);
}

// Shows what stands after the # in the address.
function readAddress() {
  const wanted = new URLSearchParams(location.hash.slice(1));
  if (wanted.has("lang"))
    language = wanted.get("lang") === "zh" ? 1 : 0;
  if (lesson.slides.length > 0)
    lesson.goTo(Math.max(0, Math.min(lesson.slides.length - 1, Number(wanted.get("slide") || 1) - 1)), !wanted.has("answered"));
  if (wanted.has("step")) {
    if (lesson.slides.length > 0 && !wanted.has("slide")) {
      lesson.phase = "free";
      showRun(runs[0]);
    }
    shown.run.moveTo(shown.run.positionOf(Number(wanted.get("step"))));
  }
  if (wanted.has("pixel"))
    shown.pixel = wanted.get("pixel").split(",").map(Number);
  showAll();
}

async function start() {
  runs.push(...await Promise.all(data.runs.map(openRun)));
  shown.run = runs[0];
  if (data.start) {
    shown.pixel = data.start.pixel || null;
    runs[0].moveTo(data.start.step === undefined ? 0 : runs[0].positionOf(data.start.step));
  }
  listenToPicture();
  listenToKeys();
  listenToButtons();
  readAddress();
}

// For programs: a promise that is fulfilled once the page stands; the number of events of the scene's run; go(k) shows the
// moment just after the event with the number k of the step log, go(-1) the cleared frame; event() is that event as the
// step log has it; pixel(x, y) what is stored.
window.rasterlens = {
  ready: start(),
  get events() { return runs[0].size; },
  go(k) {
    if (shown.run !== runs[0]) {
      lesson.phase = "free";
      showRun(runs[0]);
    }
    goTo(runs[0].positionOf(k));
  },
  event: () => shown.run.event,
  pixel: pixelAt,
};
window.rasterlens.ready.catch(error => {
  byId("remark").textContent = say("cannotOpen", error.message);
  byId("remark").hidden = false;
});
