#include "widgets/panels/inspector/form_groups.h"

#include "widgets/panels/fields/fold_heading.h"

#include <QFormLayout>

#include <algorithm>

namespace berg {

FormGroups::FormGroups(QFormLayout& form) : m_form(form) {}

FoldHeading* FormGroups::begin(const QString& key, const QString& title, bool isFolded)
{
    auto* heading = new FoldHeading(title);
    heading->setObjectName(key);
    heading->setChecked(!isFolded);
    m_form.addRow(heading);
    m_groups.push_back({.heading = heading, .rows = {}});
    return heading;
}

void FormGroups::add(QWidget* label, QWidget* row)
{
    if (label != nullptr)
        m_form.addRow(label, row);
    else
        m_form.addRow(row);
    m_groups.back().rows.push_back({.row = row});
}

void FormGroups::setRelevant(const QWidget* row, bool matters)
{
    for (FormGroup& group : m_groups)
        for (FormRow& one : group.rows)
            if (one.row == row)
                one.matters = matters;
}

void FormGroups::show() const
{
    for (const FormGroup& group : m_groups) {
        const bool isOpen = group.heading == nullptr || group.heading->isChecked();
        for (const FormRow& row : group.rows)
            m_form.setRowVisible(row.row, isOpen && row.matters);
        if (group.heading != nullptr)
            m_form.setRowVisible(group.heading, std::ranges::any_of(group.rows, &FormRow::matters));
    }
}

QStringList FormGroups::folded() const
{
    QStringList keys;
    for (const FormGroup& group : m_groups)
        if (group.heading != nullptr && !group.heading->isChecked())
            keys << group.heading->objectName();
    return keys;
}

void FormGroups::fold(const QStringList& keys)
{
    for (const FormGroup& group : m_groups)
        if (group.heading != nullptr)
            group.heading->setChecked(!keys.contains(group.heading->objectName()));
}

void FormGroups::open(const QWidget* input)
{
    const auto has = [&](const FormRow& row) {
        return row.row == input || row.row->isAncestorOf(input);
    };
    for (const FormGroup& group : m_groups)
        if (group.heading != nullptr && std::ranges::any_of(group.rows, has))
            group.heading->setChecked(true);
}

} // namespace berg
