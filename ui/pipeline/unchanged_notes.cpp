#include "ui/pipeline/unchanged_notes.h"

#include "core/render/render.h"
#include "ui/base/field_row.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace rasterlens
{
namespace
{

/// The settings that the stages before coverage read.
Settings geometryOf(const Settings& settings)
{
    Settings geometry;
    geometry.size = settings.size;
    geometry.view = settings.view;
    geometry.projection = settings.projection;
    geometry.numberType = settings.numberType;
    geometry.subpixelBits = settings.subpixelBits;
    geometry.samples = settings.samples;
    geometry.winding = settings.winding;
    geometry.cullSpace = settings.cullSpace;
    geometry.clipZ = settings.clipZ;
    geometry.reversedZ = settings.reversedZ;
    return geometry;
}

} // namespace

QString unchangedText(const Reason& why)
{
    const QString reason =
        textOf(why, [](const char* text) { return QCoreApplication::translate("Diagnostic", text); });
    return UnchangedNotes::tr("changes nothing here: %1").arg(reason);
}

UnchangedNotes::UnchangedNotes(Document& document, const std::vector<FieldRow*>& rows, QObject* parent)
    : QObject(parent), m_document(document), m_rows(rows),
      m_result(
          [this](Known known) {
              m_known = std::move(known);
              show();
          },
          [this](Lack lack) {
              Q_EMIT failed(tr("Whether a switch changes anything was not computed: %1.").arg(lackText(lack)));
          })
{
}

bool UnchangedNotes::isChanged(const FieldRow& row) const
{
    const SettingsField& field = row.field();
    return canBeUnchanged(field) && field.get(m_document.settings()) != field.get(m_document.defaults());
}

void UnchangedNotes::refresh()
{
    const auto& scene = m_document.scene();
    const bool needsSamples = std::ranges::any_of(
        m_rows, [this](const FieldRow* row) { return isChanged(*row) && factsFor(row->field()) == FactsOf::Samples; });
    const FactsOf what = needsSamples ? FactsOf::Samples : FactsOf::Faces;
    const Settings read = needsSamples ? m_document.settings() : geometryOf(m_document.settings());
    const bool asked = std::ranges::any_of(m_rows, [this](const FieldRow* row) { return isChanged(*row); }) &&
                       !unsupported(*scene, read);
    if (!asked || (m_known && (m_known->scene != scene || !(m_known->settings == read))))
        m_known.reset();
    show();
    if (!asked)
        m_result.drop();
    else if (!m_known)
        m_result.ask(
            [scene, read, what](const auto& turn) {
                return Known{scene, read, frameFacts(*scene, read, what, turn.stop())};
            },
            LatestJob::Running::Interrupt);
}

void UnchangedNotes::show()
{
    const Settings& settings = m_document.settings();
    for (FieldRow* row : m_rows) {
        std::optional<Reason> why;
        if (m_known && isChanged(*row)) {
            Settings asked = settings;
            row->field().set(asked, row->field().get(m_document.defaults()));
            why = whyUnchanged(row->field(), settings, asked, m_known->facts);
        }
        row->setNote(why ? unchangedText(*why) : QString());
    }
    Q_EMIT shown();
}

} // namespace rasterlens
