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

} // namespace rasterlens
