#pragma once

#include <QStringList>

#include <vector>

class QFormLayout;
class QWidget;

namespace berg {

class FoldHeading;

/** The rows of a form, under headings that show and hide them. */
class FormGroups
{
public:
    /** The form is borrowed and gets its rows from here. */
    explicit FormGroups(QFormLayout& form);

    /** The rows that follow are under this heading. */
    [[nodiscard]] FoldHeading* begin(const QString& key, const QString& title, bool isFolded);
    /** Without a label over the whole width. */
    void add(QWidget* label, QWidget* row);
    /** Whether the row is of use to what is shown; takes effect with `show`. */
    void setMatters(const QWidget* row, bool matters);
    /** Shows the rows that matter and are not folded away, and the headings that have some. */
    void show() const;

    /** Keys of the groups that are folded. */
    [[nodiscard]] QStringList folded() const;
    /** Those of these keys that are here are folded, the others open. */
    void fold(const QStringList& keys);

private:
    struct Row
    {
        QWidget* row = nullptr;
        bool matters = true;
    };
    struct Group
    {
        FoldHeading* heading = nullptr; ///< null: the rows before the first heading
        std::vector<Row> rows;
    };

    QFormLayout& m_form;
    std::vector<Group> m_groups{1};
};

} // namespace berg
