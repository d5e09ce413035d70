// The lesson: slides that lead through the runs. A question is asked before its picture is shown.
const lesson = {
  slide: 0,
  phase: "shown",       // "asking", "shown", "ended", or "free": the reader walks alone
  answers: new Map(),   // of slides: {given: text, right: boolean}, or null where the picture was shown without
  tries: [],            // wrong answers to the open question: indices of choices, texts, or how many pixels were found
  wantsDigits: false,   // the last answer was right as far as it went
  marks: new Set(),     // pixels that are marked as an answer: y * width + x
  secondLook: false,

  get slides() { return data.lesson ? data.lesson.slides : []; },
  get now() { return this.slides[this.slide]; },
  get asks() { return this.phase === "asking"; },
  get marksPixels() { return this.asks && this.now.question.kind === "pixels"; },
  get asksForMistake() { return this.asks && this.now.question.kind === "mistake"; },
  // Whether an open question is about this pixel: what is known of it would be the answer.
  isSecret(x, y) {
    const pixel = this.asks && this.now.question.pixel;
    return Boolean(pixel) && pixel[0] === x && pixel[1] === y;
  },
  // The moment that is shown: while a question is open, that before the answer.
  get moment() { return this.asks ? this.now.before : this.now; },

  isOfLevel(i) { return this.secondLook || this.slides[i].level === 1; },

  goTo(slide, asks = true) {
    this.slide = slide;
    this.phase = asks && this.now.question && !this.answers.has(slide) ? "asking" : "shown";
    this.marks.clear();
    this.tries = [];
    this.wantsDigits = false;
    showMoment(this.moment);
  },

  next() {
    if (this.asks) {
      this.answers.set(this.slide, this.tries.length > 0 ? { right: false, detail: "" } : null);
      this.show();
      return;
    }
    for (let i = this.slide + 1; i < this.slides.length; ++i)
      if (this.isOfLevel(i)) {
        this.goTo(i);
        return;
      }
    this.phase = "ended";
    showAll();
  },

  previous() {
    for (let i = this.slide - 1; i >= 0; --i)
      if (this.isOfLevel(i) || i === 0) {
        this.goTo(i, false);
        return;
      }
  },

  show() {
    this.phase = "shown";
    showMoment(this.moment);
  },

  // in  the answer that was given: the index of a choice, a text that was typed, or nothing: the marked pixels
  answer(given) {
    const right = this.now.question.answer;
    let isRight = false;
    let detail = "";
    if (right.pixels) {
      const width = data.runs[this.now.run].width;
      const wanted = new Set(right.pixels.map(([x, y]) => y * width + x));
      const found = [...this.marks].filter(pixel => wanted.has(pixel)).length;
      const extra = this.marks.size - found;
      isRight = found === wanted.size && extra === 0;
      detail = say("foundPixels", found, wanted.size, extra) + ". ";
    } else if (right.choice !== undefined) {
      isRight = given === right.choice;
    } else {
      isRight = isTyped(given, right.value);
      this.wantsDigits = !isRight && hasTooFewDigits(given, right.value);
    }
    const kTries = 2;
    const isLast = this.now.question.choices.length === kTries || this.tries.length + 1 === kTries;
    if (!isRight && (this.wantsDigits || !isLast)) {
      if (!this.wantsDigits)
        this.tries.push(right.pixels ? detail : given);
      showAll();
      return;
    }
    this.answers.set(this.slide, { right: isRight, detail: isRight ? "" : detail });
    this.show();
  },
};

// Whether a typed text is the value: whole numbers exactly, others within a hundredth, texts in any case.
function isTyped(text, value) {
  const typed = text.trim().replace("\u2212", "-");
  if (typeof value === "string")
    return typed.toLowerCase() === value.toLowerCase();
  const plain = /^-?\d{1,3}(,\d{3})+$/.test(typed) ? typed.replaceAll(",", "") : typed;
  const number = plain === "" ? NaN : Number(plain);
  return Number.isInteger(value) ? number === value : Math.abs(number - value) <= 0.01 * Math.abs(value);
}

// Whether it is the value, rounded to fewer digits than isTyped() takes.
function hasTooFewDigits(text, value) {
  const kDigits = 3; // are right to a hundredth, whatever they are
  const number = Number(text.trim().replace("\u2212", "-"));
  if (typeof value === "string" || Number.isInteger(value))
    return false;
  for (let digits = 1; digits < kDigits; ++digits)
    if (Number(value.toPrecision(digits)) === number)
      return true;
  return false;
}

function rightAnswer(question) {
  return question.answer.choice === undefined ? textOf(question.answer.words) : textOf(question.choices[question.answer.choice]);
}

function button(text, run) {
  const made = document.createElement("button");
  made.type = "button";
  made.textContent = text;
  made.addEventListener("click", run);
  return made;
}

// The means to answer: a field, choices, or the number of marked pixels with a button.
function showAnswerParts(question) {
  const box = byId("answer");
  box.replaceChildren();
  if (question.answer.choice !== undefined) {
    question.choices.forEach((choice, i) => {
      const made = button(textOf(choice), () => lesson.answer(i));
      made.disabled = lesson.tries.includes(i);
      box.append(made);
    });
    return;
  }
  if (question.kind === "pixels") {
    const count = document.createElement("span");
    count.id = "marked";
    count.textContent = lesson.marks.size === 0 ? say("clickPixels") : say("marked", lesson.marks.size);
    const check = button(say("check"), () => lesson.answer());
    check.disabled = lesson.marks.size === 0;
    box.append(count, check);
    return;
  }
  const field = document.createElement("input");
  field.type = "text";
  field.inputMode = "decimal";
  field.setAttribute("aria-label", textOf(question.text));
  const submit = () => {
    if (field.value.trim() === "")
      byId("verdict").textContent = say("emptyAnswer");
    else
      lesson.answer(field.value);
  };
  field.addEventListener("keydown", event => {
    if (event.key === "Enter")
      submit();
    event.stopPropagation(); // arrows move within the field
  });
  box.append(field, button(say("check"), submit));
  if (question.kind === "number")
    box.append(element("span", "muted", say("numberHint")));
}

// What came of the first try at the open question.
function tryText() {
  if (lesson.wantsDigits)
    return say("moreDigits");
  if (lesson.tries.length === 0)
    return "";
  return (typeof lesson.now.question.answer.pixels === "object" ? lesson.tries[0] : "") + say("tryAgain");
}

function showVerdict() {
  const verdict = byId("verdict");
  verdict.textContent = lesson.asks ? tryText() : "";
  verdict.className = lesson.asks ? "wrong" : "";
  const question = lesson.now.question;
  if (lesson.asks || !question || !lesson.answers.has(lesson.slide))
    return;
  const answered = lesson.answers.get(lesson.slide);
  verdict.className = !answered ? "" : answered.right ? "right" : "wrong";
  const key = !answered ? "unanswered" : answered.right ? "isRight" : "isWrong";
  verdict.textContent = (answered ? answered.detail : "") + say(key, rightAnswer(question));
}

function showEnd() {
  const questions = lesson.slides.filter((slide, i) => slide.question && lesson.isOfLevel(i)).length;
  const right = [...lesson.answers.values()].filter(answered => answered && answered.right).length;
  byId("caption").textContent = say("lessonEnd", right, questions);
}

function showLesson() {
  const isThere = lesson.slides.length > 0;
  byId("lesson").hidden = !isThere;
  if (!isThere)
    return;
  const { now, phase } = lesson;
  const isFree = phase === "free";
  byId("lesson-title").textContent = textOf(data.lesson.title);
  byId("slide-number").textContent = isFree ? "" : say("slide", lesson.slide + 1, lesson.slides.length);
  byId("question").textContent = !isFree && phase !== "ended" && now.question ? textOf(now.question.text) : "";
  byId("answer").replaceChildren();
  if (lesson.asks)
    showAnswerParts(now.question);
  byId("caption").textContent = lesson.asks || isFree ? "" : textOf(now.caption);
  byId("verdict").textContent = "";
  if (phase === "shown" || phase === "asking")
    showVerdict();
  if (phase === "ended")
    showEnd();
  byId("previous").textContent = say("previousSlide");
  byId("next").textContent = say(lesson.asks ? "skip" : "nextSlide");
  byId("next").className = lesson.asks ? "" : "main";
  byId("back").textContent = say("backToSlide");
  byId("free").textContent = say(isFree ? "lessonAgain" : "free");
  byId("previous").disabled = lesson.slide === 0;
  byId("next").disabled = phase === "ended";
  for (const id of ["previous", "next"])
    byId(id).hidden = isFree;
  byId("back").hidden = isFree || isAtMoment(lesson.moment);
  byId("second-look").checked = lesson.secondLook;
  byId("second").hidden = lesson.slides.every(slide => slide.level === 1);
}
