#pragma once

#include "widgets/sightings/import_preview.h"

#include <QWidget>

class QButtonGroup;
class QGridLayout;
class QLabel;

namespace berg {

/**
 * Asks which rows of a file belong to the same iceberg and shows the result of each answer. No
 * answer is chosen at first. Hidden if the file is clear.
 */
class ImportIdentityView : public QWidget
{
    Q_OBJECT

public:
    explicit ImportIdentityView(QWidget* parent = nullptr);

    /** Shows the choices. The answer stays chosen if it is among them. */
    void showChoices(const std::vector<IdentityChoice>& choices);
    /** Returns nullopt if nothing is chosen. */
    [[nodiscard]] const std::optional<IdentityChoice>& chosen() const { return m_chosen; }
    /** Clears the answer, for another format. */
    void clear() { m_chosen.reset(); }

signals:
    void edited();

private:
    void addRow(std::size_t index);

    std::vector<IdentityChoice> m_choices;
    std::optional<IdentityChoice> m_chosen;
    QGridLayout* m_grid = nullptr;
    QWidget* m_rows = nullptr; ///< recreated with the choices
    QButtonGroup* m_buttons = nullptr;
};

} // namespace berg
