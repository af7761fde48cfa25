#pragma once

#include <QStringList>

#include <vector>

class QFormLayout;
class QWidget;

namespace berg {

class FoldHeading;

/** Rows of a form in groups with headings that fold them. */
class FormGroups
{
public:
    /** Borrows the form, to which all rows are added here. */
    explicit FormGroups(QFormLayout& form);

    /** Begins a group: the rows added next are below this heading. */
    [[nodiscard]] FoldHeading* begin(const QString& key, const QString& title, bool isFolded);
    /** Adds a row; without a label it takes the whole width. */
    void add(QWidget* label, QWidget* row);
    /** Sets whether the row is of use to the objects shown; takes effect with `show`. */
    void setRelevant(const QWidget* row, bool matters);
    /** Shows the rows that matter and are not folded, and the headings that have such rows. */
    void show() const;

    /** Returns the keys of the folded groups. */
    [[nodiscard]] QStringList folded() const;
    /** Folds the groups with these keys and opens all others. */
    void fold(const QStringList& keys);
    /** Opens the group that contains the input. */
    void open(const QWidget* input);

private:
    struct FormRow
    {
        QWidget* row = nullptr;
        bool matters = true;
    };
    struct FormGroup
    {
        FoldHeading* heading = nullptr; ///< null for the rows before the first heading
        std::vector<FormRow> rows;
    };

    QFormLayout& m_form;
    std::vector<FormGroup> m_groups{1};
};

} // namespace berg
