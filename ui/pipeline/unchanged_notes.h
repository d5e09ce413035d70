#pragma once
#include "core/questions/unchanged.h"
#include "ui/base/latest_result.h"
#include "ui/document/document.h"

#include <QObject>

#include <memory>
#include <optional>
#include <vector>

namespace rasterlens
{

class FieldRow;

/// Why a mistake or another value of a switch changes nothing here, in the language in use.
[[nodiscard]] QString unchangedText(const Reason& why);

/// Has the rows of switches say why the value that the user chose gives the picture of the scene's own value. The facts
/// that decide it are computed on a background thread, and only while a switch that they are about is changed.
class UnchangedNotes : public QObject
{
    Q_OBJECT

public:
    /// in  rows: to outlive this object
    UnchangedNotes(Document& document, const std::vector<FieldRow*>& rows, QObject* parent = nullptr);

    /// Scene, settings or language are others.
    void refresh();
    [[nodiscard]] bool isBusy() const { return m_result.isBusy(); }

Q_SIGNALS:
    void shown(); ///< what the rows say has been looked at again
    /// The rows say nothing, for want of memory or threads.
    void failed(const QString& message);

private:
    struct Known {
        std::shared_ptr<const Scene> scene;
        Settings settings; ///< those that the facts depend on; of faces, the others at their default
        FrameFacts facts;
    };

    [[nodiscard]] bool isChanged(const FieldRow& row) const;
    void show();

    Document& m_document;
    const std::vector<FieldRow*>& m_rows;
    std::optional<Known> m_known;
    LatestResult<Known> m_result; ///< last: its thread uses the members above
};

} // namespace rasterlens
