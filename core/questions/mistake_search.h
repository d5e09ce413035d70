#pragma once
#include "core/questions/identification.h"
#include "core/questions/picture_match.h"
#include "core/questions/picture_score.h"
#include "core/questions/scene_drawings.h"

#include <QByteArray>

#include <cstddef>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace rasterlens
{

/// The search for a mistake at one size of the scene: identify() makes one or several.
class MistakeSearch
{
public:
    enum class Places { Whole, All }; ///< where the scene is looked for in the picture handed in

    /// in  `quality`: of the JPEG that the picture handed in has been, 1..100; 0 if it has been none. The search makes
    /// a
    ///     JPEG of that quality of every drawing before it compares the two.
    MistakeSearch(SceneDrawings& drawings, const QImage& picture, int quality, const IdentifyProgress& progress,
                  std::stop_token stop);

    /// What one mistake, or none, explains in a program that works as the settings say.
    [[nodiscard]] Identification single(Places places);
    /// Whether the first match leaves no more than noise does.
    [[nodiscard]] bool isSure() const;
    /// The quality of the JPEG that the picture handed in seems to have been; 0 if it seems to have been none.
    [[nodiscard]] int jpegQuality() const;
    /// Where single() has found nothing sure, looks at programs that work otherwise and at two mistakes at once; fills
    /// the list.
    void finish(Identification& found);

private:
    /// A picture that some mistakes draw, and how it fits at each place of the scene in the picture handed in.
    struct Candidate {
        QStringList mistakes; ///< ids; those after the first draw the very same picture
        Program program = Program::Own;
        QByteArray print;
        int pixels = 0;
        QRect where;
        std::vector<PictureFit> fits; ///< by place
        double trust = 1;             ///< factor of the score, where pixels had to be rounded otherwise
    };
    /// Two mistakes that leave less than one.
    struct Pair {
        QStringList mistakes;
        PictureFit fit;
        double share = 1; ///< what they leave, of what the best one leaves
    };

    void comparePlaces(Places places);
    void drawMistakes(Program program);
    void addPicture(const QString& id, const QImage& image, Program program);
    [[nodiscard]] std::vector<PictureFit> fitsOf(const QImage& image, Program program) const;
    [[nodiscard]] std::size_t nearestRight(const QImage& image) const;
    void choosePlace();
    void roundRight();
    void roundMistakes();
    [[nodiscard]] QImage worn(const QImage& image) const;
    void fill(Identification& found) const;
    [[nodiscard]] const PictureFit& bestFit() const;
    [[nodiscard]] double leastResidual() const;

    void lookForPairs(Identification& found);
    [[nodiscard]] std::optional<Pair> bestPair();
    void nameTogether(Pair pair, Identification& found);
    [[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> pairsToTry() const;

    [[nodiscard]] std::vector<MistakeMatch> matches() const;
    void pad(std::vector<MistakeMatch>& matches) const;
    [[nodiscard]] PictureNoise noiseAt(std::size_t place) const;
    [[nodiscard]] double bestScore() const;
    [[nodiscard]] double scoreAt(const Candidate& candidate, std::size_t place, const PictureNoise& noise) const;
    [[nodiscard]] double scoreOfRightAt(std::size_t place, const PictureNoise& noise) const;
    [[nodiscard]] double rightLeaves(std::size_t place) const;
    [[nodiscard]] const PictureFit* roundedAt(std::size_t place) const;
    [[nodiscard]] bool isOwnScene(const QString& id) const;
    void report();

    SceneDrawings& m_drawings;
    const QImage& m_picture;
    int m_quality;
    const IdentifyProgress& m_progress;
    std::stop_token m_stop;

    std::vector<QRect> m_places;
    std::vector<std::vector<PictureComparison>> m_comparisons; ///< by place, and by right picture
    std::vector<Candidate> m_candidates;                       ///< the right picture first
    std::size_t m_place = 0;                                   ///< the best of m_places
    PictureNoise m_noise;                                      ///< there
    int m_done = 0;
    int m_total = 0;

    /// The right picture, each pixel rounded in whatever way fits best.
    struct Rounded {
        QImage picture; ///< in the size of the comparison
        PictureFit fit;
        double freedom = 0; ///< the squared differences that this has taken away
        std::size_t place = 0;
    };
    std::optional<Rounded> m_rounded;
};

} // namespace rasterlens
