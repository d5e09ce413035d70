#pragma once
#include "core/derive/place.h"
#include "core/derive/writer.h"
#include "core/observe/step_text.h"
#include "core/questions/vertex_table.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"

#include <array>
#include <memory>
#include <optional>
#include <stop_token>

namespace rasterlens
{

/// Why there is no derivation. Thrown by the topics, caught by derive().
struct NoDerivation {
    Reason why; ///< of the context "Derive"
};

/// A face, drawn alone by the stages of render(), and what they computed.
class FaceRecord
{
public:
    FaceRecord(const Scene& scene, const Settings& settings, const DerivationPlace& place, std::stop_token stop);

    [[nodiscard]] const Scene& scene() const { return *m_scene; }
    [[nodiscard]] const Settings& settings() const { return m_settings; }
    [[nodiscard]] const DerivationPlace& place() const { return m_place; }
    /// The edge of the place, 0..2; the first where it names none.
    [[nodiscard]] std::size_t edge() const { return std::size_t(m_place.edge.value_or(0)); }
    [[nodiscard]] const Rules& rules() const { return m_log->rules(); }
    [[nodiscard]] const StepLog& log() const { return *m_log; }
    [[nodiscard]] const std::array<VertexRow, 3>& corners() const { return m_corners; }
    [[nodiscard]] Matrices matrices() const { return cameraMatrices(*m_scene, m_settings, rules().camera); }

    /// A position in samples as a place on the canvas, in pixels.
    [[nodiscard]] glm::dvec2 pixels(const glm::dvec2& samples) const { return samples / double(rules().sampleGrid); }

    /// The one-face scene, drawn with other settings, and what happens in one pixel only if a sample of it is given.
    [[nodiscard]] std::shared_ptr<const StepLog> logOf(const Settings& settings, StepFilter filter = {}) const;

    /// The payload of the first event of a kind; null if there is none.
    template <class Payload>
    [[nodiscard]] const Payload* first() const
    {
        const auto events = m_log->eventsOf(Payload::kKind);
        return events.empty() ? nullptr : &m_log->payload<Payload>(m_log->event(events.front()));
    }

private:
    const Scene* m_scene;
    Settings m_settings;
    DerivationPlace m_place;
    std::stop_token m_stop;
    Scene m_alone; ///< the scene with this face only
    std::shared_ptr<const StepLog> m_log;
    std::array<VertexRow, 3> m_corners;
};

/// A sample and the triangle it is looked at for: the face, or a piece of a cut one.
struct SampledTriangle {
    const StepTriangle* triangle;
    int x; ///< samples
    int y;
    glm::dvec2 point;  ///< samples: where the rules test it
    EdgeValues values; ///< in areas of samples: AB, BC, CA of the setup
    bool isInside;
};

enum class SampleNeed { Inside, Any };

/// The sample nearest the centre of the place's pixel, or one inside the face.
///
/// errors  throws NoDerivation: the face is not drawn, holds no sample's centre or, if it is to, not this one
[[nodiscard]] SampledTriangle sampleOf(const FaceRecord& record, SampleNeed need);

/// The numbers of the fragment at a sample inside the face, drawn with settings of a topic.
///
/// errors  throws NoDerivation where no fragment was shaded there
struct SampledFragment {
    FragmentStep numbers;
    std::optional<std::uint32_t> color; ///< 0xffRRGGBB
};
[[nodiscard]] SampledFragment fragmentOf(const FaceRecord& record, const SampledTriangle& sample,
                                         const Settings& settings);

/// Refuses where a corner of the face is not in front of the eye.
///
/// errors  throws NoDerivation
void requireBeforeEye(const FaceRecord& record);

/// `face 0, pixel (3, 4)`: what a derivation was made at.
[[nodiscard]] Reason faceReason(const FaceRecord& record);
[[nodiscard]] Reason pixelReason(const FaceRecord& record, const SampledTriangle& sample);

/// The settings with the whole area drawn by edge equation, and colours interpolated.
[[nodiscard]] Settings withArea(Settings settings);

} // namespace rasterlens
