#pragma once

#include "widgets/model/scenario_document.h"
#include "widgets/panels/inspector/form_groups.h"
#include "widgets/panels/inspector/inspector_rows.h"

#include <QWidget>

class QFormLayout;
class QLabel;

namespace berg {

/**
 * The inputs of a list of rows for one or several objects of a scenario, or for the scenario
 * itself. Several objects with different values show "mixed"; an edit is made to all of them and
 * is one undo step, as are the steps of one input that follow each other.
 */
class InspectorForm : public QWidget
{
    Q_OBJECT

public:
    InspectorForm(ScenarioDocument& document, const std::vector<InspectorRow>& rows,
                  QWidget* parent = nullptr);

    /** Puts an input of the caller's above the others. */
    void addOnTop(const QString& label, QWidget* input);
    void setTopVisible(bool visible);
    /** The first one of the list of rows. */
    [[nodiscard]] QWidget* firstInput() const { return m_first; }

    /** Ids of the objects, all of them in the scenario; one empty id: the scenario itself. */
    void showObjects(std::vector<std::string> ids);
    /** All inputs, the one on top as well. */
    void setLocked(bool locked);
    /** Takes what is being typed as if Return had been pressed. */
    void finishTyping();
    [[nodiscard]] FormGroups& groups() { return m_groups; }

signals:
    /** A group was folded or opened by the user. */
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
    /** What `read` gives for the objects; none: they differ. */
    template <class Read>
    [[nodiscard]] auto common(const Read& read) const;
    [[nodiscard]] std::optional<QString> commonText(const ReadText& read) const;
    void showText(const ReadText& read, QLabel& label, QWidget* row);

    ScenarioDocument& m_document;
    QFormLayout* m_form;
    FormGroups m_groups;
    QWidget* m_top = nullptr;
    QWidget* m_first = nullptr;
    std::vector<std::function<void()>> m_shows; ///< of the inputs: what there is of `m_ids`
    std::vector<std::string> m_ids;
};

} // namespace berg
