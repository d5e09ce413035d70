#include "ui/document/rebase.h"

#include "core/io/session.h"
#include "core/settings/numbers_field.h"

#include <utility>

namespace rasterlens
{

Rebase::Rebase(std::shared_ptr<const Scene> former, std::shared_ptr<const Scene> fresh)
    : m_former(std::move(former)), m_fresh(std::move(fresh)), m_done{{m_former, m_fresh}}
{
}

std::shared_ptr<const Scene> Rebase::scene(const std::shared_ptr<const Scene>& edited)
{
    std::shared_ptr<const Scene>& result = m_done[edited];
    if (result)
        return result;
    const std::size_t count = m_former->mesh.vertices.size();
    const bool fits = m_fresh->mesh.vertices.size() == count && edited->mesh.vertices.size() == count;
    m_movesLost = m_movesLost || !fits;
    if (!fits)
        return result = m_fresh;
    auto moved = std::make_shared<Scene>(*m_fresh);
    for (const auto& [vertex, position] : movedVertices(m_former->mesh, edited->mesh))
        moved->mesh.vertices[vertex].position = position;
    for (const auto& [vertex, color] : recoloredVertices(m_former->mesh, edited->mesh))
        moved->mesh.vertices[vertex].color = color;
    return result = std::move(moved);
}

Settings Rebase::settings(const Settings& edited) const
{
    const Settings& before = m_former->defaults;
    const Settings& now = m_fresh->defaults;
    Settings result = edited;
    for (const SettingsField& field : settingsFields())
        if (field.get(edited) == field.get(before))
            field.set(result, field.get(now));
    for (const NumbersField& field : numbersFields())
        if (isEqual(field, edited, before))
            field.set(result, field.get(now));
    if (edited.size == before.size)
        result.size = now.size;
    if (edited.view == before.view)
        result.view = now.view;
    if (edited.light == before.light)
        result.light = now.light;
    if (edited.mistakes == before.mistakes)
        result.mistakes = now.mistakes;
    return result;
}

} // namespace rasterlens
