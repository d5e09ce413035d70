#pragma once
#include "core/page/page_words.h"

#include <QTranslator>

namespace rasterlens
{

/// The words of the window for a page: the sentences, formulas and cards that its panels show. While one of these is
/// there it tells the language of all texts; nothing may be painted meanwhile.
class WindowPageWords : public PageWords
{
public:
    WindowPageWords();
    ~WindowPageWords() override;

    void use(PageLanguage language) override { m_texts.language = language; }

    [[nodiscard]] QString sceneTitle(const Scene& scene) const override;
    [[nodiscard]] QString sceneNote(const Scene& scene) const override;
    [[nodiscard]] QString mistake(const Mistake& mistake) const override;
    [[nodiscard]] QString remark(const Reason& reason) const override;
    [[nodiscard]] PageStepWords step(const StepLog& log, std::size_t i) const override;
    [[nodiscard]] PageCardWords card(const WhyReport& report) const override;

private:
    /// Stands before all other translators and gives the text of the language that is asked for.
    class Texts : public QTranslator
    {
    public:
        Texts();
        [[nodiscard]] bool isEmpty() const override { return false; }
        [[nodiscard]] QString translate(const char* context, const char* source, const char* disambiguation,
                                        int n) const override;

        PageLanguage language = PageLanguage::English;

    private:
        QTranslator m_chinese;
    };

    Texts m_texts;
};

} // namespace rasterlens
