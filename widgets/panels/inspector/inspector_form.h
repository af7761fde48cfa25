#pragma once

#include "widgets/document/scenario_document.h"
#include "widgets/panels/inspector/form_groups.h"
#include "widgets/panels/inspector/inspector_rows.h"

#include <QWidget>

class QFormLayout;
class QLabel;

namespace berg {

/**
 * Inputs of a list of rows for one or several objects of a scenario, or for the scenario itself.
 * Different values show "mixed"; an edit applies to all objects and is one undo step, as are
 * successive steps of one input.
 */
class InspectorForm : public QWidget
{
    Q_OBJECT

public:
    InspectorForm(ScenarioDocument& document, const std::vector<InspectorRow>& rows,
                  QWidget* parent = nullptr);

    /** Adds an input of the caller above the others. */
    void addOnTop(const QString& label, QWidget* input);
    void setTopVisible(bool visible);
    /** Returns the input of the first row. */
    [[nodiscard]] QWidget* firstInput() const { return m_first; }
    /** Returns the texts of the inputs that matter to the object with this id. */
    [[nodiscard]] std::vector<RowWords> inputsOf(const std::string& id) const;
    /** Opens the group of the input with this key, focuses and returns the input. */
    QWidget* goTo(const QString& key);

    /**
     * Shows the objects with these ids, which exist in the scenario; one empty id shows the
     * scenario.
     */
    void showObjects(std::vector<std::string> ids);
    /** Locks all inputs, also the one on top. */
    void setLocked(bool locked);
    /** Accepts typed text as if Return had been pressed. */
    void finishTyping();
    [[nodiscard]] FormGroups& groups() { return m_groups; }

signals:
    /** Emitted when the user folded or opened a group. */
    void folded();

private:
    void showWhere(const RowWords& words, QWidget* input);
    void add(const GroupRow& row);
    void add(const NumberRow& row);
    void add(const TextRow& row);
    void add(const EntryRow& row);
    void add(const FlagRow& row);
    void add(const PickRow& row);
    void add(const ActionRow& row);
    void add(const PartRow& row);
    void add(const InfoRow& row);
    void addLine(const TextRow& row);
    void addPage(const TextRow& row);
    void addInput(const RowWords& words, QWidget* input);
    void edit(const RowWords& words,
              const std::function<void(Scenario&, const std::string& id)>& change);
    void showAll();
    /** Returns the common value of `read` for the objects, or nullopt if they differ. */
    template <class Read>
    [[nodiscard]] auto common(const Read& read) const;
    [[nodiscard]] std::optional<QString> commonText(const ReadText& read) const;
    void showText(const ReadText& read, QLabel& label, QWidget* row);

    ScenarioDocument& m_document;
    QFormLayout* m_form;
    FormGroups m_groups;
    QWidget* m_top = nullptr;
    QWidget* m_first = nullptr;
    struct Input
    {
        RowWords words;
        QWidget* input = nullptr;
    };
    std::vector<Input> m_inputs;
    std::vector<std::function<void()>> m_shows; ///< update the inputs from the objects in `m_ids`
    std::vector<std::string> m_ids;
};

} // namespace berg
