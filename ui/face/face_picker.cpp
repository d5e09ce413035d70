#include "ui/face/face_picker.h"

#include "ui/base/field_row.h"
#include "ui/base/numbers.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>

#include <algorithm>

namespace rasterlens
{

void FaceSelection::setCount(std::uint32_t count)
{
    m_count = count;
    m_face = count == 0 ? 0 : std::min(m_face, count - 1);
    Q_EMIT changed();
}

void FaceSelection::setFace(std::uint32_t face)
{
    if (face == m_face || face >= m_count)
        return;
    m_face = face;
    Q_EMIT changed();
}

FacePicker::FacePicker(FaceSelection& selection, QWidget* parent)
    : QWidget(parent), m_selection(selection), m_name(new QLabel), m_spin(new PanelSpin), m_total(new QLabel)
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(5);
    m_total->setObjectName(QStringLiteral("muted"));
    m_spin->setKeyboardTracking(false);
    m_spin->setMinimumWidth(62);
    row->addWidget(m_name);
    row->addWidget(m_spin);
    row->addWidget(m_total);
    connect(m_spin, &QSpinBox::valueChanged, &selection,
            [&selection](int face) { selection.setFace(static_cast<std::uint32_t>(face)); });
    connect(&selection, &FaceSelection::changed, this, &FacePicker::sync);
    sync();
}

void FacePicker::sync()
{
    const QSignalBlocker blocked(m_spin);
    m_spin->setRange(0, static_cast<int>(m_selection.count()) - 1);
    m_spin->setValue(static_cast<int>(m_selection.face()));
    m_spin->setEnabled(m_selection.count() > 1);
    m_name->setText(tr("Face"));
    m_spin->setAccessibleName(m_name->text());
    m_total->setText(tr("of %1").arg(grouped(m_selection.count())));
    m_spin->setToolTip(
        tr("Faces are the triangles, counted from 0. A click on a pixel chooses the face seen there; the line beside "
           "a face is that of the f statement in the OBJ file that it is a part of."));
}

void FacePicker::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        sync();
    QWidget::changeEvent(event);
}

} // namespace rasterlens
