#pragma once
#include "core/io/reach.h"

#include <QObject>
#include <QStringList>

#include <atomic>

namespace rasterlens
{

/// The files that may name others outside their folders because the user has agreed, in this run or an earlier one.
class Consents : public QObject
{
    Q_OBJECT

public:
    /// The consents of the program, whose settings keep them.
    [[nodiscard]] static Consents& ofProgram();

    /// The user agrees for every file of this run.
    void addAll() { m_all = true; }
    void add(const QString& file);

    /// What is decided now: Consent takes it, in a background thread, too.
    ///
    /// in  own: a file that the program itself has written; may be empty
    [[nodiscard]] std::function<Outside(const QString& file)> decided(const QString& own = {}) const;

    /// Tells by refused() what was not read, at the next turn of the event loop. Any thread may call it.
    void tell(const std::vector<Consent::Refused>& all);
    /// Whether tell() has had anything to tell in this run.
    [[nodiscard]] bool hasTold() const { return m_hasTold; }

Q_SIGNALS:
    /// This file names others outside its folder, which were not read.
    void refused(const QString& file, const QStringList& paths);

private:
    bool m_all = false;
    std::atomic<bool> m_hasTold = false;
};

} // namespace rasterlens
