#pragma once
#include "core/base/reason.h"

#include <QString>

#include <functional>
#include <vector>

namespace rasterlens
{

/// Whether a file may have the program read others that lie outside of its own folder. Files come from strangers, and
/// what they name need not be theirs.
enum class Outside {
    Refuse,
    Allow, ///< the user has agreed
};

/// The part of the disk that a model, a session or a lesson may name files of.
struct Reach {
    QString folder;
    Outside outside = Outside::Refuse;

    /// Whether a file of that name may be read. A name that leads out is not looked for on the disk, which may be one
    /// of another computer.
    ///
    /// covers  `..`, absolute names, links to other places; resources of the program are never outside
    [[nodiscard]] bool covers(const QString& path) const;
};

/// What the user has agreed to. While one lives, it decides for the files that its thread reads; without one every
/// reach ends at the folder of the file.
class Consent
{
public:
    /// A file that was not read, and the one that names it.
    struct Refused {
        QString owner;
        QString path;
    };

    explicit Consent(Outside outside);
    explicit Consent(std::function<Outside(const QString& file)> of);
    ~Consent();
    Consent(const Consent&) = delete;
    Consent& operator=(const Consent&) = delete;

    [[nodiscard]] const std::vector<Refused>& refused() const { return m_refused; }

    /// The reach of a file by the consent of this thread: its own folder and those below it, or everything.
    [[nodiscard]] static Reach reachOf(const QString& file);
    /// Notes what is not read, for refused().
    static void refuse(const QString& owner, const QString& path);

private:
    std::function<Outside(const QString& file)> m_of;
    std::vector<Refused> m_refused;
    Consent* m_former; ///< that of this thread before
};

/// Why a file that a model names is not read: a sentence without the file name.
[[nodiscard]] Reason outsideReason();

} // namespace rasterlens
