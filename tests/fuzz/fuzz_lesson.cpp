// Lessons: the JSON of a lesson file. Texts of what is read get their numbers; slides are not drawn.
#include "core/lessons/lesson.h"
#include "tests/fuzz/target.h"

using namespace rasterlens;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const LessonLoad load = lessonFromJson(fuzz::bytesOf(data, size), QStringLiteral("fuzz.json"));
    fuzz::requireReason(load.lesson, load.diagnostics);
    if (!load.lesson)
        return 0;
    fuzz::require(!load.lesson->slides.empty(), "a lesson has slides");
    for (const Slide& slide : load.lesson->slides) {
        (void)textWithNumbers(slide.moment.caption, slide);
        fuzz::require(slide.question.has_value() == slide.before.has_value(), "a question has a picture before it");
        if (slide.question)
            (void)textWithNumbers(slide.question->text, slide);
    }
    return 0;
}
