#pragma once
#include <QImage>
#include <QString>
#include <QTextBrowser>
#include <QTimer>

#include <map>
#include <optional>
#include <vector>

namespace rasterlens
{

/// Shows a document that the program carries with it, written in Markdown. Pictures take the width of the column at
/// most, and on no screen fewer points than they have, so that they stay sharp.
class GuideView : public QTextBrowser
{
    Q_OBJECT

public:
    struct Heading {
        int level; ///< 1 is the title of the document
        QString text;
        int position; ///< in the document
    };

    explicit GuideView(QWidget* parent = nullptr);

    /// Whether the program carries a document of that name.
    [[nodiscard]] static bool hasPage(const QString& name);
    /// in  the name of a document in docs: `GUIDE.md`; hasPage() holds
    void setPage(const QString& name);
    [[nodiscard]] const QString& page() const { return m_page; }
    [[nodiscard]] const std::vector<Heading>& headings() const { return m_headings; }
    /// The heading that a link names: `the-first-minute` is "The first minute".
    [[nodiscard]] std::optional<std::size_t> headingNamed(const QString& anchor) const;
    /// The last heading above the upper end of what is in sight; nothing above the first one.
    [[nodiscard]] std::optional<std::size_t> headingInSight() const;
    void showHeading(std::size_t index);

    /// What a link to a heading names it by: small letters, digits and signs of words, with hyphens for blanks.
    [[nodiscard]] static QString anchorOf(const QString& heading);
    /// The picture as it is shown where the column has so many canvas pixels.
    [[nodiscard]] QImage fitted(const QImage& picture, int columnWidth) const;

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void layOut();
    void finishLayout() const;
    void layOutBlocks();
    void layOutTables();
    void layOutCode();
    void addPictures();
    [[nodiscard]] int columnWidth() const;
    [[nodiscard]] QImage original(const QString& name);

    QString m_page;
    QString m_text;                      ///< of the page, in Markdown
    QTextDocument* m_document = nullptr; ///< of the page
    QTimer m_layOutSoon;                 ///< fonts and colours change several at a time
    std::vector<Heading> m_headings;
    std::map<QString, QImage> m_pictures; ///< as they are in the resources
};

} // namespace rasterlens
