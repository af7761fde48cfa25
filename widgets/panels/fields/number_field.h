#pragma once

#include <QDoubleSpinBox>

#include <optional>

class QFormLayout;

namespace berg {

/** Numbers of decimals: trailing zeros beyond `least` are omitted. */
struct Decimals
{
    int least = 0;
    int most = 0;
};

/**
 * A number field. Setting a value emits nothing; `edited` reports changes by the user. Typing is
 * accepted when it ends (Return, loss of focus). The field can stand for several objects with
 * different numbers: then it is empty and shows "mixed". Other units and clock times are converted
 * ("15 kn", "45 min", "0:45" for hours and minutes); a bare number has the unit shown. Seconds are
 * shown as durations: "45 s", "45 min" or "0:16:40". A number beyond the limits becomes the nearest
 * valid one, which `remarked` reports. The wheel needs the focus.
 */
class NumberField : public QDoubleSpinBox
{
    Q_OBJECT

public:
    explicit NumberField(QWidget* parent = nullptr);

    void setNumberFormat(Decimals decimals, const QString& unit);
    /** Sets a text that is shown in place of the lowest value. */
    void setLowestText(const QString& text);
    /** Sets the range; unlike `setRange` it keeps text that is being typed. */
    void limit(double low, double high);

    void showValue(double value);
    /** Shows "mixed" for several numbers; stepping starts from `base`. */
    void showMixed(double base);
    [[nodiscard]] bool isMixed() const { return m_mixed; }

    /** Accepts typed text as if Return had been pressed. */
    void finishTyping();

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override;

signals:
    /** Emitted when the user sets a number other than the one shown. */
    void edited(double value);
    /** Emitted after the last `edited` of a series: Return was pressed or the focus left. */
    void editFinished();
    /** Reports a typed value that was not set as typed; an empty sentence clears the report. */
    void remarked(const QString& sentence);

protected:
    /**
     * Accepts the typed number before the focus moves, because the edit may insert the next field.
     */
    bool focusNextPrevChild(bool next) override;
    [[nodiscard]] double valueFromText(const QString& text) const override;
    [[nodiscard]] QString textFromValue(double value) const override;
    QValidator::State validate(QString& text, int& position) const override;
    void fixup(QString& text) const override;

private:
    void showNumber(double value, bool mixed);
    void setMixed(bool mixed);
    [[nodiscard]] bool isShown(double value) const;
    [[nodiscard]] bool isDuration() const;
    /** Returns the text of a value with its unit. */
    [[nodiscard]] QString shownText(double value) const;
    /** Returns the number of a text, or nullopt if it cannot be read. */
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
    std::optional<double> m_typed;       ///< number typed while mixed
    QString m_typing;                    ///< text typed since typing last ended
    std::optional<double> m_typedNumber; ///< number of `m_typing`; nullopt if it cannot be read
};

/**
 * Returns the field with a label for its remark below; the label's name is the field's and "Fault".
 */
[[nodiscard]] QWidget* withRemark(NumberField* field);

/** Adds a row with a label and a field with its remark to a form. */
void addNumberRow(QFormLayout& form, const QString& text, NumberField* field);

} // namespace berg
