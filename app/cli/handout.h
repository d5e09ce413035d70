#pragma once
#include "core/lessons/lesson.h"

namespace rasterlens::cli
{

/// Writes a lesson for reading: its slides with question, figure and caption, as Markdown (`F.md`, the figures beside
/// it as `F-01.png`, `F-02.png` ..) or as PDF (`F.pdf`).
///
/// errors  throws Failure: another suffix, slides that cannot be drawn, files that cannot be written
void writeHandout(const Lesson& lesson, const QString& path, bool inChinese);

} // namespace rasterlens::cli
