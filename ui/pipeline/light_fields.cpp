#include "ui/pipeline/light_fields.h"

#include "core/observe/names.h"
#include "core/questions/unchanged.h"
#include "core/scene/camera.h"
#include "ui/base/parts.h"
#include "ui/pipeline/light_ball.h"
#include "ui/pipeline/unchanged_notes.h"

#include <QCheckBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalBlocker>
#include <QVBoxLayout>

namespace rasterlens
{
namespace
{

/// Three decimals are finer than a step on the ball, and short to read. No number is -0.
glm::dvec3 rounded(const glm::dvec3& direction) { return glm::round(direction * 1000.0) / 1000.0 + 0.0; }

} // namespace

LightFields::LightFields(Document& document, QWidget* parent)
    : QWidget(parent), m_document(document), m_dot(new ChangeDot), m_name(new QLabel), m_edit(new QLineEdit),
      m_head(new QCheckBox), m_ball(new LightBall), m_note(new QLabel)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(3);
    for (QLabel* label : {m_name, m_note}) {
        label->setObjectName(QStringLiteral("muted"));
        label->setWordWrap(true);
    }
    m_edit->setObjectName(QStringLiteral("light"));
    m_head->setObjectName(QStringLiteral("headlight"));
    m_edit->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_head->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    column->addLayout(makeFieldLine(m_dot, m_name, m_edit));
    auto* room = new QLabel;
    room->setFixedWidth(m_dot->width());
    column->addLayout(makeFieldLine(room, m_ball, m_head));
    constexpr QMargins kUnderTheName(14, 0, 18, 2);
    m_note->setContentsMargins(kUnderTheName);
    column->addWidget(m_note);

    m_field = new TypedField(m_edit,
                             [this](const QString& text, TypedField::Attempt attempt) { return read(text, attempt); });
    connect(m_field, &TypedField::refused, this, &LightFields::invalidInput);
    connect(m_field, &TypedField::mended, this, &LightFields::inputMended);
    connect(m_dot, &ChangeDot::clicked, this, [this] { set(m_document.defaults().light); });
    connect(m_head, &QCheckBox::toggled, this, [this](bool on) { set(on ? Light{std::nullopt} : m_direction); });
    connect(m_ball, &LightBall::dragged, this, &LightFields::drag);
    connect(m_ball, &LightBall::dropped, this, [this] { m_document.endGesture(); });
}

void LightFields::set(const Light& light, Document::Edit edit)
{
    Settings next = m_document.settings();
    next.light = light;
    m_document.setSettings(next, edit);
}

void LightFields::drag(const glm::dvec3& towardsView)
{
    const Matrices matrices = cameraMatrices(*m_document.scene(), m_document.settings());
    const glm::dvec3 world = glm::transpose(glm::dmat3(matrices.viewFromObject)) * towardsView;
    set(Light{rounded(world)}, Document::Edit::Camera);
}

std::optional<QString> LightFields::read(const QString& text, TypedField::Attempt attempt)
{
    if (text == valueText())
        return std::nullopt;
    const auto light = parseLight(text.trimmed());
    if (!light)
        return tr("\"%1\" is no direction. Write three numbers x, y, z that are not all 0.").arg(text);
    if (attempt == TypedField::Attempt::Take) {
        set(*light);
        m_field->setValue(valueText());
    }
    return std::nullopt;
}

QString LightFields::valueText() const
{
    const Light& light = m_document.settings().light;
    const glm::dvec3 shown =
        light.isHead() ? rounded(cameraMatrices(*m_document.scene(), m_document.settings()).toViewer) : *light.towards;
    QStringList words;
    for (int i = 0; i < 3; ++i)
        words << shortNumber(shown[i]);
    return words.join(QStringLiteral(", "));
}

QString LightFields::note() const { return m_note->text(); }

void LightFields::sync()
{
    const Settings& settings = m_document.settings();
    if (!settings.light.isHead())
        m_direction = settings.light;
    m_field->setValue(valueText());
    const QSignalBlocker blocked(m_head);
    m_head->setChecked(settings.light.isHead());
    const bool isMoved = settings.light != m_document.defaults().light;
    m_dot->setChanged(isMoved);
    const Matrices matrices = cameraMatrices(*m_document.scene(), settings);
    m_ball->setLight(glm::dmat3(matrices.viewFromObject) * settings.light.towards.value_or(matrices.toViewer));
    const auto why = isMoved ? whyLightUnchanged(*m_document.scene(), settings) : std::nullopt;
    m_note->setText(why ? unchangedText(*why) : QString());
    m_note->setVisible(why.has_value());
}

void LightFields::retranslate()
{
    m_name->setText(tr("Towards the light"));
    m_edit->setAccessibleName(m_name->text());
    m_edit->setToolTip(tr("The direction from the scene to the light: x, y, z in world space. Its length does not "
                          "matter."));
    m_name->setToolTip(m_edit->toolTip());
    m_head->setText(tr("Headlight"));
    m_head->setToolTip(tr("The light shines along the camera's view and turns with it."));
    m_ball->setToolTip(tr("Drag the bright side of the ball. With Shift the light comes from behind it."));
    m_dot->setToolTip(tr("Put back what the scene asks for"));
    sync();
}

} // namespace rasterlens
