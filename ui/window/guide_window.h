#pragma once
#include "ui/base/language.h"

#include <QString>
#include <QWidget>

#include <vector>

class QListWidget;
class QToolButton;

namespace rasterlens
{

class GuideView;

/// The guide of the program in a window of its own: contents, pages and pictures come from the resources, in the
/// language of the main window. Links lead to the other documents, and Back returns.
class GuideWindow : public QWidget
{
    Q_OBJECT

public:
    explicit GuideWindow(QWidget* parent);

    /// Opens the window, at the place where it was left.
    void open();
    void setLanguage(LanguageKind kind);
    [[nodiscard]] GuideView& view() { return *m_view; }
    [[nodiscard]] QListWidget& contents() { return *m_contents; }
    /// Follows a link of a page: `#heading`, `OTHER.md` or `OTHER.md#heading`. Addresses of the web go to the system's
    /// browser; what is neither leads nowhere.
    void follow(const QUrl& link);
    void goBack();
    [[nodiscard]] bool canGoBack() const { return !m_visited.empty(); }

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    struct Place {
        QString page;
        int scroll;
    };

    void showPage(const QString& page);
    void fillContents();
    void fitContents();
    void goToHeading(std::size_t index);
    void remember();
    void syncContents();
    void retranslate();
    [[nodiscard]] QString guideName() const;

    GuideView* m_view;
    QListWidget* m_contents;
    QToolButton* m_back;
    QToolButton* m_toGuide;
    LanguageKind m_language = LanguageKind::English;
    std::vector<Place> m_visited; ///< in their order
};

} // namespace rasterlens
