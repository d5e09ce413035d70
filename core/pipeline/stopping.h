#pragma once

namespace rasterlens
{

/// Whether the frame that an algorithm finds samples for is to be ended. Algorithms ask once a row: one face can cover
/// a picture of 16384 x 16384.
///
/// in  emit  what is called for each sample; one without a member stopped() is never stopped
template <class Emit>
[[nodiscard]] bool isStopped(const Emit& emit)
{
    if constexpr (requires { emit.stopped(); })
        return emit.stopped();
    else
        return false;
}

/// Whether a row or column of samples is to be left out, since it was drawn before the moment from which the triangle
/// is drawn on. Algorithms ask at each of their lines, in the order of its number, and tell nothing of one left out.
///
/// in  emit  as for isStopped(); one without a member skipsLine() leaves out none
template <class Emit>
[[nodiscard]] bool skipsLine(Emit& emit, int line)
{
    if constexpr (requires { emit.skipsLine(line); })
        return emit.skipsLine(line);
    else
        return false;
}

} // namespace rasterlens
