#pragma once

#include "app/start/start_content.h"

#include <QPointer>
#include <QWidget>

class QCheckBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace berg {

class ExampleCard;

/**
 * The first page of the program if no file is named: recent files, examples, a new scenario.
 * Covers its parent below `setTop`, whose own keys rest meanwhile. Emits intents.
 */
class StartPage : public QWidget
{
    Q_OBJECT

public:
    /** `continued`: what the first button goes on with. `offersTour`: the tour was never seen and
     * is pointed out. */
    StartPage(const QString& continued, bool showAtStart, bool offersTour, QWidget* parent);

    ~StartPage() override;

    void setTheme(const Theme& theme);
    /** Upper edge in the parent. */
    void setTop(int top_px);
    void setRecent(const QStringList& paths);

signals:
    void continueRequested();
    /** Esc: with what lies below. */
    void dismissed();
    void newRequested();
    void openRequested();
    void importRequested();
    void tourRequested();
    void fileChosen(const QString& path);
    void exampleChosen(const QString& path);
    void removeRequested(const QString& path);
    void showAtStartEdited(bool show);

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void showEvent(QShowEvent* event) override;
    bool focusNextPrevChild(bool next) override;

private:
    QPushButton* addCommand(QVBoxLayout& column, const char* name, const QString& text,
                            void (StartPage::*intent)()) const;
    QWidget* makeCommands(const QString& continued, bool showAtStart, bool offersTour);
    QWidget* makeExamples();
    void showRecent(const QList<RecentFile>& files);
    void showExample(int place, const Example& example, const QColor& sea);
    void arrangeExamples();
    void place();

    Theme m_theme = Theme::light();
    int m_top_px = 0;
    QLabel* m_title = nullptr;
    std::vector<QLabel*> m_headings;
    std::vector<QLabel*> m_captions;
    QPushButton* m_continue = nullptr;
    QVBoxLayout* m_recent = nullptr;
    QStringList m_recentPaths;
    QScrollArea* m_examples = nullptr;
    QGridLayout* m_grid = nullptr;
    std::vector<ExampleCard*> m_cards;
    /** Child of the parent: closing the page waits for no slow disk. */
    QPointer<StartContent> m_content;
};

} // namespace berg
