#pragma once

#include <QAccessibleWidget>

class QComboBox;

namespace berg {

/**
 * A list to choose from as screen readers know it: "label: value", and its actions choose. Qt tells
 * the value alone, and takes no choice but by keys and pointer.
 */
class AccessibleCombo : public QAccessibleWidget
{
public:
    explicit AccessibleCombo(QComboBox* combo);

    [[nodiscard]] QString text(QAccessible::Text kind) const override;
    [[nodiscard]] QAccessible::State state() const override;
    [[nodiscard]] int childCount() const override;
    [[nodiscard]] QAccessibleInterface* child(int index) const override;
    [[nodiscard]] int indexOfChild(const QAccessibleInterface* child) const override;
    [[nodiscard]] QStringList actionNames() const override;
    void doAction(const QString& name) override;

private:
    [[nodiscard]] QComboBox& combo() const;
};

} // namespace berg
