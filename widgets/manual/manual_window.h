#pragma once

#include "widgets/manual/manual.h"

#include <QWidget>

class QLabel;
class QLineEdit;
class QTextBrowser;
class QToolBar;
class QTreeWidget;
class QTreeWidgetItem;

namespace berg {

/**
 * The manual in a window of its own: contents or search results on the left, the chapter on the
 * right. It needs no network, and no files except for pictures.
 */
class ManualWindow : public QWidget
{
    Q_OBJECT

public:
    /** Loads the manual in the window's language. */
    explicit ManualWindow(QWidget* parent);

    /** Shows a place such as "planning#tau". */
    void showPlace(const QString& place);
    /** Place shown, such as "planning#tau". */
    [[nodiscard]] QString place() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    void addBar();
    void addKeys();
    void showContents();
    void search(const QString& words);
    void stepHit(int step);
    void go(const QTreeWidgetItem* item);
    void showLine(const QString& line);
    void follow(const QUrl& page);
    void markWords();
    void applyPalette();

    QString m_language;
    Manual m_manual;
    QToolBar* m_bar = nullptr;
    QLineEdit* m_search = nullptr;
    QLabel* m_found = nullptr;
    QTreeWidget* m_list = nullptr; ///< contents or hits
    QTextBrowser* m_text = nullptr;
};

} // namespace berg
