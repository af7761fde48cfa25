#pragma once

#include <QString>
#include <QWidget>

#include <functional>

class QLabel;
class QLineEdit;

namespace berg {

/** What was typed is taken: undoing is no longer up to the line, which keeps text and cursor. */
void settleTyping(QLineEdit& line);

/** A locked input stays as readable as it was, but no longer looks like one to write in. */
void setLockedLook(QWidget& input, bool locked);

/** Of a line: name of its input, that of the fault is this and "Fault"; name and tool tip for the
 * user. */
struct EntryWords
{
    QString key;
    QString label;
    QString toolTip;
};

/**
 * A line that takes only some texts, when typing ends; with another it goes back to what there is
 * and says why below. GUI thread.
 */
class EntryField : public QWidget
{
    Q_OBJECT

public:
    enum class Says
    {
        AtOnce,      ///< while it is typed
        WhenFinished ///< what is half typed is no fault yet
    };

    /** `whyNot(text)` is a sentence for a text that cannot be taken, empty for one that can. */
    EntryField(const EntryWords& words, Says says, std::function<QString(const QString&)> whyNot,
               QWidget* parent = nullptr);

    /** `placeholder` is what an empty line says. */
    void showText(const QString& text, const QString& placeholder = {});
    /** What was taken last. */
    [[nodiscard]] QString text() const { return m_shown; }
    void setLocked(bool locked);
    /** Takes what is typed as if Return had been pressed. */
    void finishTyping();

signals:
    void edited(const QString& text);

private:
    void say(const QString& fault);

    std::function<QString(const QString&)> m_whyNot;
    QLineEdit* m_line;
    QLabel* m_fault;
    QString m_shown;
};

} // namespace berg
