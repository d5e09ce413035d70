// The lesson: slides that lead through the runs. A question is asked before its picture is shown.
const lesson = {
  slide: 0,
  phase: "shown",       // "asking", "shown", "ended", or "free": the reader walks alone
  answers: new Map(),   // of slides: {given: text, right: boolean}, or null where the picture was shown without
  marks: new Set(),     // pixels that are marked as an answer: y * width + x
  secondLook: false,

  get slides() { return data.lesson ? data.lesson.slides : []; },
  get now() { return this.slides[this.slide]; },
  get asks() { return this.phase === "asking"; },
  get marksPixels() { return this.asks && this.now.question.kind === "pixels"; },
  // The moment that is shown: while a question is open, that before the answer.
  get moment() {
    if (!this.asks)
      return this.now;
    return this.now.before || (this.slide > 0 ? this.slides[this.slide - 1] : this.now);
  },

  isOfLevel(i) { return this.secondLook || this.slides[i].level === 1; },

  goTo(slide, asks = true) {
    this.slide = slide;
    this.phase = asks && this.now.question && !this.answers.has(slide) ? "asking" : "shown";
    this.marks.clear();
    showMoment(this.moment);
  },

  next() {
    if (this.asks) {
      this.answers.set(this.slide, null);
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

function rightAnswer(question) {
  return question.answer.choice === undefined ? question.answer.words : textOf(question.choices[question.answer.choice]);
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
    question.choices.forEach((choice, i) => box.append(button(textOf(choice), () => lesson.answer(i))));
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
}

function showVerdict() {
  const verdict = byId("verdict");
  verdict.textContent = "";
  verdict.className = "";
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
  if (phase === "shown")
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
