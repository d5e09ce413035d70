#include "ui/pipeline/plane_fields.h"

#include "core/base/typed_numbers.h"
#include "core/observe/names.h"
#include "core/scene/camera.h"
#include "core/settings/view_planes.h"

#include <QCoreApplication>
#include <QVBoxLayout>

namespace rasterlens
{

PlaneFields::PlaneFields(Document& document, QWidget* parent) : QWidget(parent), m_document(document)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(3);
    addRow(kNear);
    addRow(kFar);
}

void PlaneFields::addRow(std::size_t which)
{
    auto* row = new TypedRow(
        which == kNear ? QStringLiteral("nearPlane") : QStringLiteral("farPlane"),
        [this, which](const QString& text, TypedField::Attempt attempt) { return read(which, text, attempt); });
    connect(row, &TypedRow::invalidInput, this, &PlaneFields::invalidInput);
    connect(row, &TypedRow::inputMended, this, &PlaneFields::inputMended);
    connect(row, &TypedRow::resetRequested, this, [this, which] {
        View asked = m_document.defaults().view;
        set(which, distance(asked, which));
    });
    m_rows[which] = row;
    layout()->addWidget(row);
}

std::optional<double>& PlaneFields::distance(View& view, std::size_t which)
{
    return which == kNear ? view.near : view.far;
}

void PlaneFields::set(std::size_t which, std::optional<double> to)
{
    Settings next = m_document.settings();
    distance(next.view, which) = to;
    m_document.setSettings(next);
}

std::optional<QString> PlaneFields::read(std::size_t which, const QString& text, TypedField::Attempt attempt)
{
    std::optional<double> typed;
    const bool isLeftToCamera = text.trimmed().isEmpty() || text == valueText(which);
    if (!isLeftToCamera) {
        const auto numbers = typedNumbers(text);
        if (!numbers || numbers->size() != 1)
            return tr("\"%1\" is not a distance. Write a number greater than 0, or nothing.").arg(text);
        typed = numbers->front();
        const Matrices inUse = cameraMatrices(*m_document.scene(), m_document.settings());
        View view = m_document.settings().view;
        distance(view, which) = typed;
        // The near plane that an orthographic camera chooses itself may lie behind the eye.
        const auto near = view.near || inUse.near > 0 ? view.near.value_or(inUse.near) : view.near;
        if (const auto why = whyNotPlanes(near, view.far.value_or(inUse.far)))
            return textOf(*why, [](const char* words) { return QCoreApplication::translate("Diagnostic", words); });
    }
    if (attempt == TypedField::Attempt::Take && text != valueText(which)) {
        set(which, typed);
        m_rows[which]->field().setValue(valueText(which));
    }
    return std::nullopt;
}

QString PlaneFields::valueText(std::size_t which) const
{
    View view = m_document.settings().view;
    const Matrices inUse = cameraMatrices(*m_document.scene(), m_document.settings());
    const QString number = shortNumber(which == kNear ? inUse.near : inUse.far);
    return distance(view, which) ? number : tr("auto (%1)").arg(number);
}

void PlaneFields::sync()
{
    setVisible(m_document.scene()->space == SceneSpace::Object);
    View now = m_document.settings().view;
    View asked = m_document.defaults().view;
    for (const std::size_t which : {kNear, kFar})
        m_rows[which]->sync(valueText(which), distance(now, which) != distance(asked, which));
}

void PlaneFields::retranslate()
{
    const QString toolTip = tr("Distance from the eye. Leave it empty and the camera puts the plane round the scene.");
    const QString putBack = tr("Put back what the scene asks for");
    m_rows[kNear]->setTexts(tr("Near plane"), toolTip, putBack);
    m_rows[kFar]->setTexts(tr("Far plane"), toolTip, putBack);
    sync();
}

} // namespace rasterlens
