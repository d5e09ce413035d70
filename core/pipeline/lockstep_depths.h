#pragma once
#include <cstddef>
#include <cstdint>
#include <unordered_map>

namespace rasterlens
{

/// The depths that two threads see which draw the faces 2k and 2k + 1 at the same time without a lock: at each sample
/// both read, then both write. So the second face of a pair is compared with what was there before the first.
class LockstepDepths
{
public:
    /// The samples that follow belong to this face.
    void begin(std::uint32_t face)
    {
        if (m_face / 2 != face / 2)
            m_before.clear();
        m_face = face;
    }

    /// The depth that the face is compared with at a sample where the buffer holds `now`.
    [[nodiscard]] float read(std::size_t at, float now)
    {
        if (m_face % 2 == 0)
            return m_before.try_emplace(at, now).first->second;
        const auto before = m_before.find(at);
        return before != m_before.end() ? before->second : now;
    }

private:
    std::uint32_t m_face = 0;
    std::unordered_map<std::size_t, float> m_before; ///< where the first face of the pair has been tested
};

} // namespace rasterlens
