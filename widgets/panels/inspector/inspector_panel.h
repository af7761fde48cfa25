#pragma once

#include "widgets/model/scenario_document.h"
#include "widgets/model/selection.h"
#include "widgets/theme/theme.h"

#include <QWidget>

class QLabel;
class QVBoxLayout;

namespace berg {

class CaptionLabel;
class EntryField;
class InspectorForm;

/**
 * The numbers of what is selected: icebergs, UAVs, asset, area, or the scenario when nothing is.
 * Edits go to the document, one undo step for each gesture; of things of several kinds selected
 * together those that come first in this list are shown. What is being typed belongs to what was
 * selected when it was typed.
 */
class InspectorPanel : public QWidget
{
    Q_OBJECT

public:
    /** Both are borrowed and must outlive the panel. */
    InspectorPanel(ScenarioDocument& document, Selection& selection, QWidget* parent = nullptr);
    ~InspectorPanel() override;

    void setTheme(const Theme& theme);
    /** In flight: values can be read but not changed. */
    void setLocked(bool locked);
    /** Takes what is being typed as if Return had been pressed, e.g. before saving. */
    void finishTyping();

    /** Keys of the groups of rows that are folded away. */
    [[nodiscard]] QStringList foldedGroups() const;
    void foldGroups(const QStringList& keys);

signals:
    /** A group of rows was folded or opened by the user. */
    void folded();
    /** Esc, where nothing is being typed. */
    void left();

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    /** A row of a mark and a text that may wrap. */
    struct Notice
    {
        QWidget* row = nullptr;
        QLabel* mark = nullptr;
        QLabel* text = nullptr;
    };

    [[nodiscard]] QVBoxLayout* addScrollArea();
    [[nodiscard]] Notice addNotice(QVBoxLayout& column, const QString& name);
    void addForms(QVBoxLayout& column);
    void lockInputs();
    void changeSelection();
    void refresh();
    [[nodiscard]] InspectorForm* formInUse() const;
    void showTitle();
    void showIssues();
    [[nodiscard]] bool isConcerned(const Issue& issue) const;
    [[nodiscard]] EntryField* addIdField(InspectorForm& form, const QString& key,
                                         const QString& toolTip, const QString& missing,
                                         const std::vector<std::string>& shown);
    void showChip();
    [[nodiscard]] QString whyTaken(const QString& id) const;
    void rename(const std::string& before, const std::string& after);

    ScenarioDocument& m_document;
    Selection& m_selection;
    Theme m_theme = Theme::light();
    QLabel* m_chip = nullptr; ///< colour of the UAV
    QLabel* m_title = nullptr;
    CaptionLabel* m_subtitle = nullptr;
    Notice m_lock;
    Notice m_issues;
    InspectorForm* m_icebergForm = nullptr;
    InspectorForm* m_uavForm = nullptr;
    InspectorForm* m_assetForm = nullptr;
    InspectorForm* m_areaForm = nullptr;
    InspectorForm* m_noFlyForm = nullptr;
    InspectorForm* m_scenarioForm = nullptr;
    std::vector<InspectorForm*> m_forms; ///< all of them
    EntryField* m_icebergId = nullptr;
    EntryField* m_uavId = nullptr;
    std::vector<std::string> m_icebergs; ///< selected, in the scenario
    std::vector<std::string> m_uavs;
    std::string m_noFly; ///< key of the first one selected; empty: none
    bool m_locked = false;
};

} // namespace berg
