#pragma once

#include "widgets/document/scenario_document.h"
#include "widgets/document/selection.h"
#include "widgets/theme/theme.h"

#include <QWidget>

#include <array>
#include <optional>
#include <string>
#include <vector>

class QLabel;
class QVBoxLayout;

namespace berg {

class CaptionLabel;
class EntryField;
class InspectorForm;

/**
 * Editor of the selection: icebergs, UAVs, asset, area, or the scenario without a selection. Edits
 * go to the document, one undo step for each gesture. If objects of several kinds are selected, the
 * first kind in this list is shown. Unfinished typing is applied to the objects selected when it
 * was typed.
 */
class InspectorPanel : public QWidget
{
    Q_OBJECT

public:
    /** Borrows both, which must outlive the panel. */
    InspectorPanel(ScenarioDocument& document, Selection& selection, QWidget* parent = nullptr);
    ~InspectorPanel() override;

    void setTheme(const Theme& theme);
    /** Locks the values in flight, when they can be read but not changed. */
    void setLocked(bool locked);
    /** Accepts typed text as if Return had been pressed, e.g. before saving. */
    void finishTyping();

    /** Returns the keys of the folded groups of rows. */
    [[nodiscard]] QStringList foldedGroups() const;
    void foldGroups(const QStringList& keys);

    /** An input, for the search box. */
    struct Field
    {
        QString key;
        QString label;
        QString of; ///< kind of object it belongs to: "UAV"
    };
    /**
     * Returns the inputs of the scenario and of the first selected iceberg and UAV, or of the first
     * ones.
     */
    [[nodiscard]] std::vector<Field> fields() const;
    /** Selects an object with the input and focuses the input. */
    void goToField(const QString& key);

signals:
    /** Emitted when the user folded or opened a group of rows. */
    void folded();
    /** Emitted by Esc while nothing is being typed. */
    void left();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    /** An icon and a text that may wrap. */
    struct Notice
    {
        QWidget* row = nullptr;
        QLabel* mark = nullptr;
        QLabel* text = nullptr;
    };

    struct Fielded
    {
        InspectorForm* form;
        std::optional<std::string> id; ///< object whose numbers it shows; nullopt if there is none
        QString name;
    };
    [[nodiscard]] std::array<Fielded, 3> fielded() const;
    [[nodiscard]] QVBoxLayout* addScrollArea();
    void addNotices(QVBoxLayout& rows);
    [[nodiscard]] Notice addNotice(QVBoxLayout& column, const QString& name);
    void showNotices();
    void addForms(QVBoxLayout& column);
    void lockInputs();
    void changeSelection();
    void refresh();
    [[nodiscard]] InspectorForm* formInUse() const;
    void showTitle();
    void showIssues();
    [[nodiscard]] bool isConcerned(const Issue& issue) const;
    [[nodiscard]] EntryField* addIdField(InspectorForm& form, const QString& key,
                                         const QString& toolTip,
                                         const std::vector<std::string>& shown);
    void showChip();
    void rename(const std::string& before, const std::string& after);

    ScenarioDocument& m_document;
    Selection& m_selection;
    Theme m_theme = Theme::light();
    QLabel* m_chip = nullptr; ///< colour of the UAV
    QLabel* m_title = nullptr;
    CaptionLabel* m_subtitle = nullptr;
    QWidget* m_notices = nullptr; ///< below the rows
    QWidget* m_room = nullptr;    ///< empty space at the end of the rows
    Notice m_lock;
    Notice m_issues;
    InspectorForm* m_icebergForm = nullptr;
    InspectorForm* m_uavForm = nullptr;
    InspectorForm* m_assetForm = nullptr;
    InspectorForm* m_areaForm = nullptr;
    InspectorForm* m_noFlyForm = nullptr;
    InspectorForm* m_scenarioForm = nullptr;
    std::vector<InspectorForm*> m_forms; ///< all forms
    EntryField* m_icebergId = nullptr;
    EntryField* m_uavId = nullptr;
    std::vector<std::string> m_icebergs; ///< selected icebergs of the scenario
    std::vector<std::string> m_uavs;
    std::string m_noFly; ///< key of the first selected no-fly area; may be empty
    bool m_locked = false;
};

} // namespace berg
