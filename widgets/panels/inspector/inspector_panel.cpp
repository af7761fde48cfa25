#include "widgets/panels/inspector/inspector_panel.h"

#include "core/checks/validate.h"
#include "widgets/document/scenario_edits.h"
#include "widgets/panels/fields/entry_field.h"
#include "widgets/panels/fields/panel_labels.h"
#include "widgets/panels/inspector/inspector_form.h"
#include "widgets/theme/icons.h"
#include "widgets/theme/palette.h"
#include "widgets/words/intervention_text.h"
#include "widgets/words/issue_text.h"

#include <QApplication>
#include <QEvent>
#include <QFormLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QPointer>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <string_view>
#include <unordered_set>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kMargin_px = 10;
constexpr int kGap_px = 6;
constexpr int kMark_px = 16;
constexpr int kChip_px = 12;
constexpr int kNoticeLines = 3; ///< maximum; the tool tip has all of them

/** Returns the ids that are in `objects`, in the order of selection. */
template <class Object>
std::vector<std::string> idsAmong(const std::vector<Object>& objects,
                                  const std::vector<std::string>& ids)
{
    if (ids.empty())
        return {};
    std::unordered_set<std::string_view> known;
    for (const Object& object : objects)
        known.insert(object.id);
    std::vector<std::string> found;
    std::copy_if(ids.begin(), ids.end(), std::back_inserter(found),
                 [&](const std::string& id) { return known.contains(id); });
    return found;
}

/** Returns whether the finding concerns one of `ids`, which are in `list` of the file. */
template <class Object>
bool isAbout(const Issue& issue, std::string_view list, const std::vector<Object>& objects,
             const std::vector<std::string>& ids)
{
    const std::optional<std::size_t> index = issueIndex(issue, list);
    if (!index || *index >= objects.size())
        return false;
    const std::string& id = objects[*index].id;
    return std::find(ids.begin(), ids.end(), id) != ids.end();
}

bool isOnly(const std::vector<std::string>& ids)
{
    return ids.size() == 1;
}

/** Several objects are edited together, but the id of a single one only. */
void showIdOfOnly(const std::vector<std::string>& ids, InspectorForm& form, EntryField& field)
{
    form.setTopVisible(isOnly(ids));
    if (isOnly(ids))
        field.showText(QString::fromStdString(ids.front()));
}

} // namespace

InspectorPanel::InspectorPanel(ScenarioDocument& document, Selection& selection, QWidget* parent)
    : QWidget(parent), m_document(document), m_selection(selection)
{
    QVBoxLayout* column = addScrollArea();
    m_title = new QLabel;
    m_title->setObjectName(u"inspectorTitle"_s);
    m_subtitle = new CaptionLabel;
    m_subtitle->setObjectName(u"inspectorSubtitle"_s);
    m_chip = new QLabel;
    m_chip->setObjectName(u"inspectorChip"_s);
    auto* heading = new QHBoxLayout;
    heading->setSpacing(kGap_px);
    heading->addWidget(m_chip);
    heading->addWidget(m_title, 1);
    column->addLayout(heading);
    column->addWidget(m_subtitle);
    addForms(*column);
    column->addStretch();
    addNotices(*column);

    connect(&document, &ScenarioDocument::scenarioChanged, this, &InspectorPanel::refresh);
    connect(&selection, &Selection::changed, this, &InspectorPanel::changeSelection);
    setTheme(Theme::light());
    refresh();
}

InspectorPanel::~InspectorPanel()
{
    // Inputs accept typed text when they are hidden, which happens after this body.
    m_document.disconnect(this);
    m_selection.disconnect(this);
}

QVBoxLayout* InspectorPanel::addScrollArea()
{
    auto* outer = new QVBoxLayout(this);
    outer->setContentsMargins(0, 0, 0, 0);
    auto* area = new QScrollArea(this);
    area->setObjectName(u"inspectorScroll"_s);
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    area->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    area->setFocusPolicy(Qt::NoFocus);
    auto* page = new QWidget;
    area->setWidget(page);
    outer->addWidget(area);
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(kMargin_px, kMargin_px, kMargin_px, kMargin_px);
    column->setSpacing(kGap_px);
    return column;
}

/** Adds the notices below the rows; the space at the end of the rows shrinks by their height. */
void InspectorPanel::addNotices(QVBoxLayout& rows)
{
    m_notices = new QWidget;
    m_notices->setObjectName(u"inspectorNotices"_s);
    auto* column = new QVBoxLayout(m_notices);
    column->setContentsMargins(kMargin_px, 0, kMargin_px, kGap_px);
    column->setSpacing(0);
    m_lock = addNotice(*column, u"inspectorLock"_s);
    m_lock.text->setText(lockedInFlightText());
    m_lock.row->hide();
    m_issues = addNotice(*column, u"inspectorIssues"_s);
    m_room = new QWidget;
    m_room->setObjectName(u"inspectorRoom"_s);
    rows.addWidget(m_room);
    layout()->addWidget(m_notices);
}

/**
 * The notices take at most `kNoticeLines`; the rest of that height is empty space at the end of the
 * rows. The scroll range is therefore the same with and without notices, and no row moves.
 */
void InspectorPanel::showNotices()
{
    const int most_px = kNoticeLines * std::max(kMark_px, fontMetrics().lineSpacing()) + kGap_px;
    int height_px = kGap_px;
    for (const Notice& notice : {m_lock, m_issues})
        if (!notice.row->isHidden())
            height_px += std::max(kMark_px, notice.text->heightForWidth(width() - 2 * kMargin_px -
                                                                        kMark_px - kGap_px));
    const bool hasAny = height_px > kGap_px;
    height_px = hasAny ? std::min(height_px, most_px) : 0;
    if (m_room->maximumHeight() == most_px - height_px)
        return;
    QScrollBar& bar = *findChild<QScrollArea*>()->verticalScrollBar();
    const int scrolled_px = bar.value();
    m_notices->setFixedHeight(height_px);
    m_notices->setVisible(hasAny);
    m_room->setFixedHeight(most_px - height_px);
    QEvent arrange(QEvent::LayoutRequest);
    QCoreApplication::sendEvent(m_room->parentWidget(), &arrange); // updates both at once
    layout()->activate();
    bar.setValue(scrolled_px);
}

void InspectorPanel::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    showNotices();
}

InspectorPanel::Notice InspectorPanel::addNotice(QVBoxLayout& column, const QString& name)
{
    Notice notice{.row = new QWidget, .mark = new QLabel, .text = new QLabel};
    auto* row = new QHBoxLayout(notice.row);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kGap_px);
    notice.mark->setFixedSize(kMark_px, kMark_px);
    notice.text->setObjectName(name);
    notice.text->setWordWrap(true);
    row->addWidget(notice.mark, 0, Qt::AlignTop);
    row->addWidget(notice.text, 1);
    column.addWidget(notice.row);
    return notice;
}

void InspectorPanel::addForms(QVBoxLayout& column)
{
    m_icebergForm = new InspectorForm(m_document, icebergRows());
    m_uavForm = new InspectorForm(m_document, uavRows());
    m_assetForm = new InspectorForm(m_document, assetRows());
    m_areaForm = new InspectorForm(m_document, areaRows());
    m_scenarioForm = new InspectorForm(m_document, scenarioRows());
    m_noFlyForm = new InspectorForm(m_document, noFlyRows());
    m_forms = {m_icebergForm, m_uavForm, m_assetForm, m_areaForm, m_noFlyForm, m_scenarioForm};
    m_icebergId =
        addIdField(*m_icebergForm, u"iceberg"_s,
                   tr("Identifies the iceberg in files and lists; must be unique."), m_icebergs);
    m_uavId = addIdField(*m_uavForm, u"uav"_s,
                         tr("Identifies the UAV in files and lists; must be unique."), m_uavs);
    for (InspectorForm* form : m_forms) {
        column.addWidget(form);
        connect(form, &InspectorForm::folded, this, &InspectorPanel::folded);
    }
}

QStringList InspectorPanel::foldedGroups() const
{
    QStringList keys;
    for (InspectorForm* form : m_forms)
        keys += form->groups().folded();
    return keys;
}

void InspectorPanel::foldGroups(const QStringList& keys)
{
    for (InspectorForm* form : m_forms)
        form->groups().fold(keys);
}

/** Returns the forms whose inputs can be found by name. */
std::array<InspectorPanel::Fielded, 3> InspectorPanel::fielded() const
{
    const auto first = [](const std::vector<std::string>& selected, const auto& objects) {
        if (!selected.empty())
            return std::optional(selected.front());
        return objects.empty() ? std::nullopt : std::optional(objects.front().id);
    };
    const Scenario& scenario = m_document.scenario();
    return {{{.form = m_scenarioForm, .id = std::string(), .name = tr("Scenario")},
             {.form = m_uavForm, .id = first(m_uavs, scenario.uavs), .name = tr("UAV")},
             {.form = m_icebergForm,
              .id = first(m_icebergs, scenario.icebergs),
              .name = tr("Iceberg")}}};
}

std::vector<InspectorPanel::Field> InspectorPanel::fields() const
{
    std::vector<Field> fields;
    for (const auto& [form, id, name] : fielded())
        if (id)
            for (const RowWords& words : form->inputsOf(*id))
                fields.push_back({.key = words.key, .label = words.label, .of = name});
    return fields;
}

void InspectorPanel::goToField(const QString& key)
{
    for (const auto& [form, id, name] : fielded()) {
        const auto inputs = id ? form->inputsOf(*id) : std::vector<RowWords>();
        if (std::ranges::find(inputs, key, &RowWords::key) == inputs.end())
            continue;
        if (form != formInUse())
            m_selection.set(id->empty() ? std::vector<std::string>() : std::vector{*id});
        const QPointer<QWidget> input = form->goTo(key);
        const auto scroll = [this, input] {
            auto& area = *findChild<QScrollArea*>();
            QEvent arrange(QEvent::LayoutRequest);
            QCoreApplication::sendEvent(area.widget(), &arrange);
            if (input)
                area.ensureWidgetVisible(input);
        };
        scroll();
        QTimer::singleShot(0, this, scroll); // labels wrap once the form is shown, which moves rows
        return;
    }
}

/** Adds the id field on top of its form; it shows the only id in `shown`, which may change. */
EntryField* InspectorPanel::addIdField(InspectorForm& form, const QString& key,
                                       const QString& toolTip,
                                       const std::vector<std::string>& shown)
{
    auto* field =
        new EntryField({.key = key + u"Id"_s, .label = tr("Id"), .toolTip = toolTip},
                       EntryField::ValidationTime::AtOnce, [this](const QString& id) {
                           const auto fault = idFault(m_document.scenario(), id.toStdString());
                           return fault ? issueSentence(fault->id, fault->arguments) : QString();
                       });
    form.addOnTop(tr("Id"), field);
    connect(field, &EntryField::edited, this, [this, &shown](const QString& id) {
        if (shown.empty())
            return;
        // A copy, because `shown` changes during the renaming.
        // NOLINTNEXTLINE(performance-unnecessary-copy-initialization)
        const std::string before = shown.front();
        rename(before, id.toStdString());
    });
    return field;
}

void InspectorPanel::setTheme(const Theme& theme)
{
    m_theme = theme;
    showChip();
    setCaptionTheme(*this, theme);
    m_title->setFont(theme.strong());
    m_lock.mark->setPixmap(
        icon(IconName::Locked, theme).pixmap(QSize(kMark_px, kMark_px), devicePixelRatioF()));
    m_issues.mark->setPixmap(
        icon(IconName::Warning, theme).pixmap(QSize(kMark_px, kMark_px), devicePixelRatioF()));
    lockInputs(); // their ground is a colour of the palette
}

void InspectorPanel::setLocked(bool locked)
{
    if (locked == m_locked)
        return;
    m_locked = locked;
    m_lock.row->setVisible(locked);
    showNotices();
    lockInputs();
    if (const QWidget* focused = QApplication::focusWidget();
        locked && focused != nullptr && isAncestorOf(focused))
        emit left(); // a locked field has no use for the keys of a flight
}

void InspectorPanel::lockInputs()
{
    for (InspectorForm* form : m_forms)
        form->setLocked(m_locked);
}

void InspectorPanel::finishTyping()
{
    if (m_locked)
        return;
    for (InspectorForm* form : m_forms)
        form->finishTyping();
}

/** Receives the keys that no input uses. */
void InspectorPanel::keyPressEvent(QKeyEvent* event)
{
    const auto lines = findChildren<QLineEdit*>();
    const bool isTyping = std::ranges::any_of(lines, &QLineEdit::isModified);
    if (event->key() == Qt::Key_Escape && !isTyping)
        emit left();
    else
        QWidget::keyPressEvent(event);
}

void InspectorPanel::changeSelection()
{
    finishTyping();
    refresh();
}

void InspectorPanel::refresh()
{
    const Scenario& scenario = m_document.scenario();
    m_icebergs = idsAmong(scenario.icebergs, m_selection.ids());
    m_uavs = idsAmong(scenario.uavs, m_selection.ids());
    const auto noFly = std::ranges::find_if(m_selection.ids(), [&](const std::string& id) {
        return noFlyPlace(id) && outlineIn(scenario, id) != nullptr;
    });
    m_noFly = noFly == m_selection.ids().end() ? std::string() : *noFly;
    m_noFlyForm->showObjects({m_noFly});
    m_icebergForm->showObjects(m_icebergs);
    m_uavForm->showObjects(m_uavs);
    for (InspectorForm* form : {m_assetForm, m_areaForm, m_scenarioForm})
        form->showObjects({std::string()});
    showIdOfOnly(m_icebergs, *m_icebergForm, *m_icebergId);
    showIdOfOnly(m_uavs, *m_uavForm, *m_uavId);
    const InspectorForm* shown = formInUse();
    if (shown->isHidden()) // another form starts at its top
        findChild<QScrollArea*>()->verticalScrollBar()->setValue(0);
    for (InspectorForm* form : m_forms)
        form->setVisible(form == shown);
    setFocusProxy(shown->firstInput());
    showTitle();
    showIssues();
}

InspectorForm* InspectorPanel::formInUse() const
{
    if (!m_icebergs.empty())
        return m_icebergForm;
    if (!m_uavs.empty())
        return m_uavForm;
    const Scenario& scenario = m_document.scenario();
    if (scenario.asset && m_selection.contains(kAssetKey))
        return m_assetForm;
    if (!scenario.area_m.empty() && m_selection.contains(kAreaKey))
        return m_areaForm;
    return m_noFly.empty() ? m_scenarioForm : m_noFlyForm;
}

void InspectorPanel::showTitle()
{
    QString title = tr("Scenario");
    QString subtitle = tr("Select an object on the map to edit it.");
    if (formInUse() == m_assetForm) {
        title = tr("Asset");
        subtitle.clear();
    } else if (formInUse() == m_areaForm) {
        title = tr("Area");
        subtitle = tr("Drag its corners on the map to change it.");
    } else if (formInUse() == m_noFlyForm) {
        title = tr("No-fly area");
        subtitle = tr("Drag its corners on the map to change it.");
    } else if (!m_icebergs.empty()) {
        const auto count = static_cast<int>(m_icebergs.size());
        title = count == 1 ? tr("Iceberg") : tr("%n icebergs", nullptr, count);
        subtitle = m_uavs.empty() ? QString() : tr("Only the selected icebergs are edited here.");
        if (m_uavs.empty() && count > 1)
            subtitle = tr("Edits apply to all of them.");
    } else if (!m_uavs.empty()) {
        const auto count = static_cast<int>(m_uavs.size());
        title = count == 1 ? tr("UAV %1").arg(QString::fromStdString(m_uavs.front()))
                           : tr("%n UAVs", nullptr, count);
        subtitle = count > 1 ? tr("Edits apply to all of them.") : QString();
    }
    m_title->setText(title);
    m_subtitle->setText(subtitle);
    m_subtitle->setVisible(!subtitle.isEmpty());
    showChip();
}

/** Shows the colour that the UAV has on the map. */
void InspectorPanel::showChip()
{
    const std::vector<Uav>& uavs = m_document.scenario().uavs;
    const bool isOne = formInUse() == m_uavForm && isOnly(m_uavs);
    m_chip->setVisible(isOne);
    if (!isOne)
        return;
    const auto place = std::find_if(uavs.begin(), uavs.end(),
                                    [&](const Uav& uav) { return uav.id == m_uavs.front(); });
    QPixmap chip(QSize(kChip_px, kChip_px) * devicePixelRatioF());
    chip.setDevicePixelRatio(devicePixelRatioF());
    chip.fill(uavColour(m_theme, static_cast<int>(place - uavs.begin())));
    m_chip->setPixmap(chip);
}

void InspectorPanel::showIssues()
{
    QStringList texts;
    for (const Issue& issue : m_document.issues())
        if (isConcerned(issue))
            texts << issueText(issue);
    texts.removeDuplicates(); // several icebergs may have the same finding
    m_issues.text->setText(texts.join(u'\n'));
    m_issues.text->setToolTip(m_issues.text->text()); // the panel may not have room for all of them
    m_issues.row->setVisible(!texts.isEmpty());
    showNotices();
}

/** Returns whether the finding concerns what is shown; asset and area are part of the scenario. */
bool InspectorPanel::isConcerned(const Issue& issue) const
{
    const Scenario& scenario = m_document.scenario();
    const InspectorForm* shown = formInUse();
    if (shown == m_icebergForm)
        return isAbout(issue, "icebergs", scenario.icebergs, m_icebergs);
    if (shown == m_uavForm)
        return isAbout(issue, "uavs", scenario.uavs, m_uavs);
    if (shown == m_assetForm)
        return issue.field.starts_with("asset");
    if (shown == m_areaForm)
        return issue.field.starts_with("area_m");
    if (shown == m_noFlyForm) // findings about the whole list are shown for each area
        return issue.field == "no_fly" || issueIndex(issue, "no_fly") == *noFlyPlace(m_noFly);
    return !issueIndex(issue, "icebergs") && !issueIndex(issue, "uavs");
}

void InspectorPanel::rename(const std::string& before, const std::string& after)
{
    // Both ids are selected while the document changes, so that the selection is never empty.
    m_selection.set({before, after});
    m_document.edit(tr("Change id"),
                    [&](Scenario& scenario) { renameObject(scenario, before, after); });
    m_selection.set({after});
}

} // namespace berg
