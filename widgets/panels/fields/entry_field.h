#pragma once

#include <QString>
#include <QWidget>

#include <functional>

class QLabel;
class QLineEdit;

namespace berg {

/** Marks typed text as accepted: clears the line's undo history, keeps text and cursor. */
void settleTyping(QLineEdit& line);

/** Shows an input as locked or editable; its text stays readable. */
void setLockedStyle(QWidget& input, bool locked);

/**
 * Texts of a line: object name `key` (the fault label is `key` + "Fault"), and label and tool tip
 * for the user.
 */
struct EntryWords
{
    QString key;
    QString label;
    QString toolTip;
};

/**
 * A line that checks its text when typing ends. If the text is rejected, the line restores the
 * previous text and shows the reason below. GUI thread.
 */
class EntryField : public QWidget
{
    Q_OBJECT

public:
    enum class ValidationTime
    {
        AtOnce,      ///< while typing
        WhenFinished ///< when typing ends, because incomplete text is no fault yet
    };

    /**
     * `faultOf(text)` returns a sentence on why a text is rejected, or an empty text if it is
     * accepted.
     */
    EntryField(const EntryWords& words, ValidationTime when,
               std::function<QString(const QString&)> faultOf, QWidget* parent = nullptr);

    /** Shows a text; an empty line shows `placeholder`. */
    void showText(const QString& text, const QString& placeholder = {});
    /** The text accepted last. */
    [[nodiscard]] QString text() const { return m_shown; }
    void setLocked(bool locked);
    /** Accepts the typed text as if Return had been pressed. */
    void finishTyping();

signals:
    void edited(const QString& text);

private:
    void say(const QString& fault);

    std::function<QString(const QString&)> m_faultOf;
    QLineEdit* m_line;
    QLabel* m_fault;
    QString m_shown;
};

} // namespace berg
