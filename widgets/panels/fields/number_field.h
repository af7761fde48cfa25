#pragma once

#include <QDoubleSpinBox>

#include <optional>

class QFormLayout;

namespace berg {

/** Decimals of a number: trailing zeros beyond `least` are not written. */
struct Decimals
{
    int least = 0;
    int most = 0;
};

/**
 * A number to be edited. Shows what it is given without telling anybody; tells what the user made
 * of it. Typing counts when it is finished (Return, focus leaves). It can stand for several things
 * with different numbers: then it is empty and says "mixed". Other units and clock times are
 * converted ("15 kn", "45 min", "0:45" for hours and minutes); a number alone is in the unit that
 * was shown. Seconds are shown as durations: "45 s", "45 min" or "0:16:40". A number beyond the
 * limits becomes the nearest that can be set, and `remarked` says so. The wheel needs the focus.
 */
class NumberField : public QDoubleSpinBox
{
    Q_OBJECT

public:
    explicit NumberField(QWidget* parent = nullptr);

    void setNumberFormat(Decimals decimals, const QString& unit);
    /** In place of the lowest value. */
    void setLowestText(const QString& text);
    /** As `setRange`, which would take away what the user is typing even if nothing changes. */
    void limit(double low, double high);

    void showValue(double value);
    /** Several numbers; stepping starts from `base`. */
    void showMixed(double base);
    [[nodiscard]] bool isMixed() const { return m_mixed; }

    /** Takes what is typed as if Return had been pressed. */
    void finishTyping();

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    /** By the user, to a number other than the one shown. */
    void edited(double value);
    /** The last `edited` of a row: Return was pressed or the focus left. */
    void editFinished();
    /** A sentence about what was typed and could not be set as it was; empty: no longer. */
    void remarked(const QString& sentence);

protected:
    [[nodiscard]] double valueFromText(const QString& text) const override;
    [[nodiscard]] QString textFromValue(double value) const override;
    QValidator::State validate(QString& text, int& position) const override;
    void fixup(QString& text) const override;

private:
    void showNumber(double value, bool mixed);
    void setMixed(bool mixed);
    [[nodiscard]] bool isShown(double value) const;
    [[nodiscard]] bool isDuration() const;
    /** The text of a value with its unit. */
    [[nodiscard]] QString shownText(double value) const;
    /** Nullopt if what is typed cannot be read. */
    [[nodiscard]] std::optional<double> numberIn(QString text) const;
    void remark();
    void noteTyping(const QString& text);
    void commit(double value);
    void finish();

    int m_leastDecimals = 0;
    QString m_unit;
    QString m_lowestText;
    double m_shown = 0;
    bool m_mixed = false;
    bool m_editing = false;
    std::optional<double> m_typed;       ///< while mixed
    QString m_typing;                    ///< since typing ended last
    std::optional<double> m_typedNumber; ///< what `m_typing` says; nullopt if it cannot be read
};

/** The field and below it, while there is one, its remark: named after the field and "Fault". */
[[nodiscard]] QWidget* withRemark(NumberField* field);

/** Adds a row of a form: a label with this text is the field's, and the field has its remark. */
void addNumberRow(QFormLayout& form, const QString& text, NumberField* field);

} // namespace berg
