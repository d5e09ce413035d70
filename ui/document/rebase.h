#pragma once
#include "core/scene/scene.h"

#include <map>
#include <memory>

namespace rasterlens
{

/// Carries what the user did to a scene over to the same scene read anew from changed files.
class Rebase
{
public:
    /// in      both scenes as they were read, without moved vertices
    Rebase(std::shared_ptr<const Scene> former, std::shared_ptr<const Scene> fresh);

    /// The fresh scene with the vertices moved and coloured as in `edited`, which comes from the former one.
    ///
    /// covers  a mesh with another number of vertices: nothing is edited, and movesLost() tells
    [[nodiscard]] std::shared_ptr<const Scene> scene(const std::shared_ptr<const Scene>& edited);

    /// Values that the user had not changed follow the fresh scene's wishes; all others stay.
    [[nodiscard]] Settings settings(const Settings& edited) const;

    [[nodiscard]] bool movesLost() const { return m_movesLost; }

private:
    std::shared_ptr<const Scene> m_former;
    std::shared_ptr<const Scene> m_fresh;
    std::map<std::shared_ptr<const Scene>, std::shared_ptr<const Scene>> m_done;
    bool m_movesLost = false;
};

} // namespace rasterlens
