// The texts of the page itself, in both languages. What is said of a step, of a pixel or of a slide stands in the data.
const kWords = {
  language: ["中文", "English"],
  edge: ["edge", "边"],
  value: ["E", "E"],
  sign: ["sign", "符号"],
  owns: ["E = 0 is", "E = 0 时"],
  left: ["ours (left)", "归本面（左边）"],
  top: ["ours (top)", "归本面（上边）"],
  neither: ["not ours", "不归本面"],
  lens: ["The sample under the lens", "透镜下的采样点"],
  noSample: ["This step tests no sample.", "这一步不判断采样点。"],
  numbers: ["Counted up to this step", "到这一步为止的计数"],
  tested: ["tested", "判断"],
  covered: ["covered", "覆盖"],
  passed: ["passed", "通过深度"],
  failed: ["failed", "未过深度"],
  written: ["written", "写入"],
  twice: ["hit twice", "命中两次"],
  play: ["Play", "播放"],
  pause: ["Pause", "暂停"],
  first: ["To the start (Home)", "到开头（Home）"],
  back: ["One step back (Left)", "后退一步（左键）"],
  on: ["One step on (Right)", "前进一步（右键）"],
  last: ["To the end (End)", "到末尾（End）"],
  scrubber: ["Steps", "步骤"],
  picture: ["The picture; click a pixel, or move with Shift and an arrow, and press Enter",
            "图像；点一个像素，或用 Shift 加方向键移动，再按回车"],
  start: ["Before the first step", "第一步之前"],
  startSentence: ["The frame is cleared: every pixel has the background's colour.", "画面已清空：每个像素都是背景色。"],
  counter: ["step %1 of %2", "第 %1 步，到 %2 为止"],
  counterStart: ["start of steps 0 to %1", "开头，后面是第 0 到 %1 步"],
  counterNone: ["no steps", "没有步骤"],
  counterStill: ["finished picture", "完成的画面"],
  legendSigns: ["inside this edge; outside; exactly on it", "在边内；在边外；恰在边上"],
  legendEdge: ["edge", "边"],
  cardTitle: ["Why pixel (%1, %2)?", "像素 (%1, %2) 为什么是这样？"],
  cardEmpty: ["Why this pixel?", "这个像素为什么是这样？"],
  cardHint: ["Click a pixel of the picture: every face that could concern it is listed here, with what became of it.",
             "点一下图像里的像素：这里列出可能与它有关的每个面，以及各面的结果。"],
  stored: ["stored at this step: %1, depth %2", "这一步的存储值：%1，深度 %2"],
  storedColor: ["stored at this step: %1", "这一步的存储值：%1"],
  finished: ["In the finished picture: %1", "完成的画面里：%1"],
  noFace: ["No face comes near this pixel.", "没有面靠近这个像素。"],
  noCard: ["The page has no list of faces for this pixel; rasterlens-cli why has one.",
           "本页没有这个像素的面列表；rasterlens-cli why 可以列出。"],
  eventsHere: ["Steps at this pixel", "这个像素上的步骤"],
  moreEvents: ["and %1 more", "另有 %1 步"],
  slide: ["slide %1 of %2", "第 %1 页，共 %2 页"],
  previousSlide: ["Previous", "上一页"],
  nextSlide: ["Next", "下一页"],
  skip: ["Show without an answer", "不作答，直接看"],
  backToSlide: ["Back to the slide", "回到本页"],
  free: ["All steps of the scene", "场景的全部步骤"],
  lessonAgain: ["To the lesson", "回到课程"],
  secondLook: ["With slides for a second look", "包括进阶页"],
  check: ["Check", "检查"],
  marked: ["%1 marked", "已标 %1 个"],
  clickPixels: ["Click pixels of the picture to mark them.", "点图像里的像素来标记。"],
  isRight: ["Right: %1", "正确：%1"],
  isWrong: ["Not so. The answer: %1", "不对。答案是：%1"],
  unanswered: ["The answer: %1", "答案是：%1"],
  foundPixels: ["%1 of %2 found, %3 too many", "找到 %2 个中的 %1 个，多标 %3 个"],
  tryAgain: ["Not quite. One more try.", "不对，再试一次。"],
  moreDigits: ["Right so far: three digits, please.", "到这里都对，请给出三位有效数字。"],
  numberHint: ["whole, or three digits", "整数，或三位有效数字"],
  emptyAnswer: ["Type a number first.", "请先输入一个数。"],
  lessonEnd: ["The end of the lesson. %1 of %2 questions answered right.", "课程结束。%2 个问题答对 %1 个。"],
  withoutMistake: ["Show it without the mistake", "显示没有错误的画面"],
  withMistake: ["Show it with the mistake", "显示有错误的画面"],
  otherPicture: ["Show the picture it is compared with", "显示对比的画面"],
  thisPicture: ["Show the slide's picture", "显示本页的画面"],
  zoomIn: ["Zoom to the step", "放大到这一步"],
  zoomOut: ["Show the whole picture", "显示整个画面"],
  limit: ["The page ends after %1 steps, and so does its picture. A larger --limit holds more.",
          "本页到第 %1 步为止，画面也到此为止。更大的 --limit 可以保存更多步骤。"],
  still: ["Too many steps for this page: it has the picture, not the way to it.",
          "步骤太多，本页只有画面，没有画的过程。"],
  stillStep: ["Too many steps for this page: it has the picture at this one step.",
              "步骤太多，本页只有这一步的画面。"],
  oneStep: ["step %1", "第 %1 步"],
  closeCard: ["Close the card (Escape)", "关闭卡片（Escape）"],
  onlyFace: ["Only the steps of face %1 are told.", "只讲面 %1 的步骤。"],
  onlyPixel: ["Only the steps at pixel (%1, %2) are told.", "只讲像素 (%1, %2) 上的步骤。"],
  cannotOpen: ["This page cannot be shown. It needs a browser of the year 2023 or later. (%1)",
               "本页无法显示，需要 2023 年以后的浏览器。（%1）"],
  noEvents: ["There is no step to show.", "没有可以显示的步骤。"],
  mistakeOn: ["Switched on: %1", "已打开：%1"],
};

// 0 English, 1 Chinese.
let language = navigator.language.startsWith("zh") ? 1 : 0;

function filled(text, values) {
  return text.replace(/%(\d)/g, (_, digit) => values[digit - 1]);
}

// A text of the page, with values in place of %1, %2 ..
function say(key, ...values) {
  return filled(kWords[key][language], values);
}

// A text of the data by its number. One that is the same in both languages stands there once; of texts that differ by
// their numbers alone there is one form, and the numbers of each.
function textOf(number) {
  const text = data.texts[number];
  if (typeof text === "string")
    return text;
  if (typeof text[0] === "string")
    return text[language];
  const values = text[1].split(" ");
  return textOf(text[0]).replaceAll("\ufffc", () => values.shift());
}

// An edge value in areas of samples with all its decimals; in fixed point a number has more than a double prints.
function areaText(value, unitsPerArea) {
  if (!Number.isInteger(value) || Math.abs(value) > Number.MAX_SAFE_INTEGER || unitsPerArea !== 65536)
    return signed(value / unitsPerArea);
  const decimals = BigInt(Math.abs(value)) * (10n ** 16n) / 65536n; // 1/65536 has 16 decimals
  const digits = String(decimals).padStart(17, "0");
  const text = `${digits.slice(0, -16)}.${digits.slice(-16)}`.replace(/\.?0+$/, "");
  return (value > 0 ? "+" : value < 0 ? "\u2212" : "") + text;
}

// A number with the minus sign of printed books, and a plus in front of what is greater than 0.
function signed(value) {
  return (value > 0 ? "+" : "") + String(value).replace("-", "\u2212");
}
