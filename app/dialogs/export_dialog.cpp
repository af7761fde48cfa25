#include "app/dialogs/export_dialog.h"

#include "app/dialogs/escape_key.h"
#include "app/dialogs/export_options_view.h"
#include "widgets/flight/mission_runner.h"
#include "widgets/theme/accessible_roles.h"
#include "widgets/words/export_text.h"
#include "widgets/words/issue_text.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr QSize kSize_px(1120, 700);
constexpr int kChoices_px = 340;
constexpr int kNotes_px = 84;
constexpr int kPathPause_ms = 200;

QString stringOf(std::string_view text)
{
    return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

QString withEnding(const QString& path, std::string_view extension)
{
    for (const ExportFormat& format : exportFormats()) {
        const QString ending = u'.' + stringOf(format.extension);
        if (path.endsWith(ending, Qt::CaseInsensitive))
            return path.chopped(ending.size()) + u'.' + stringOf(extension);
    }
    return path + u'.' + stringOf(extension);
}

/** A kind of effect and what it is about, as one line of rich text. */
QString noteLine(const QString& effect, const QString& sentence)
{
    return u"<b>%1:</b> %2"_s.arg(effect.toHtmlEscaped(), sentence.toHtmlEscaped());
}

} // namespace

ExportDialog::ExportDialog(MissionRunner& runner, const ExportOffer& offer, QWidget* parent)
    : QDialog(parent), m_runner(runner), m_offer(offer)
{
    setWindowTitle(tr("Export"));
    setSizeGripEnabled(true);
    auto* sides = new QHBoxLayout;
    sides->setSpacing(12);
    sides->addWidget(makeChoices());
    sides->addLayout(makeResult(), 1);
    auto* column = new QVBoxLayout(this);
    column->addLayout(sides, 1);
    column->addLayout(makeFile());
    column->addWidget(makeButtons());
    closeOnEscape(*this);
    connect(&m_runner, &MissionRunner::exportPreviewReady, this, &ExportDialog::take);
    // The preview belongs to a scenario that has been replaced.
    connect(&m_runner, &MissionRunner::begun, this, &QDialog::reject);
    connect(m_formats, &QListWidget::currentRowChanged, this, &ExportDialog::showFormat);
    connect(m_options, &ExportOptionsView::edited, this, &ExportDialog::request);
    m_pathPause = new QTimer(this);
    m_pathPause->setSingleShot(true);
    m_pathPause->setInterval(kPathPause_ms);
    connect(m_pathPause, &QTimer::timeout, this, &ExportDialog::request);
    connect(m_path, &QLineEdit::textChanged, this, [this] {
        showState();
        m_pathPause->start(); // what is exported is the same: no hurry
    });
    resize(kSize_px);
    chooseFormat(offer.suggested.formatId);
    m_export->setDefault(true); // of the dialog, now that it has its buttons
    m_formats->setFocus();
}

ExportDialog::~ExportDialog()
{
    m_runner.cancelExportPreview();
}

QWidget* ExportDialog::makeChoices()
{
    auto* side = new QWidget;
    side->setFixedWidth(kChoices_px);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    m_formats = new QListWidget;
    m_formats->setObjectName(u"formatList"_s);
    m_formats->setAccessibleName(tr("Format of the file"));
    followSelection(*m_formats);
    m_formats->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff); // ends in an ellipsis
    addFormats();
    m_options = new ExportOptionsView(*m_offer.scenario, m_offer.flown, m_offer.suggested.options);
    column->addWidget(m_formats, 1);
    column->addSpacing(4);
    column->addWidget(m_options);
    return side;
}

/** Those for what there is, below the name of their group. */
void ExportDialog::addFormats()
{
    for (const ExportGroup group :
         {ExportGroup::Autopilots, ExportGroup::Maps, ExportGroup::Pages, ExportGroup::Tables}) {
        auto* head = new QListWidgetItem(exportGroupText(group), m_formats);
        head->setFlags(Qt::NoItemFlags);
        for (const ExportFormat& format : exportFormats()) {
            const ExportFormatText text = exportFormatText(format);
            if (text.group != group || (format.holds.flownOnly && !m_offer.flown))
                continue;
            auto* item = new QListWidgetItem(
                u"    %1 (.%2) · %3"_s.arg(text.name, stringOf(format.extension), text.tool),
                m_formats);
            item->setData(Qt::UserRole, stringOf(format.id));
        }
    }
}

QVBoxLayout* ExportDialog::makeResult()
{
    auto* column = new QVBoxLayout;
    m_about = new QLabel;
    m_about->setObjectName(u"formatAbout"_s);
    m_about->setWordWrap(true);
    m_view = new ExportPreviewView(m_offer.theme);
    m_notes = new QLabel;
    m_notes->setObjectName(u"exportNotes"_s);
    m_notes->setWordWrap(true);
    m_notes->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_notes->setMinimumHeight(kNotes_px); // so that the map does not jump
    m_notes->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    column->addWidget(m_about);
    column->addWidget(m_view, 1);
    column->addWidget(m_notes);
    return column;
}

QLayout* ExportDialog::makeFile()
{
    auto* grid = new QGridLayout;
    m_suggested = m_offer.suggested.path;
    m_path = new QLineEdit(m_suggested);
    m_path->setObjectName(u"exportPath"_s);
    auto* label = new QLabel(tr("&File"));
    label->setBuddy(m_path);
    auto* browseButton = new QPushButton(tr("&Browse..."));
    browseButton->setAutoDefault(false);
    connect(browseButton, &QPushButton::clicked, this, &ExportDialog::browse);
    m_fileNote = new QLabel;
    m_fileNote->setObjectName(u"exportFileNote"_s);
    m_fileNote->setWordWrap(true);
    grid->addWidget(label, 0, 0);
    grid->addWidget(m_path, 0, 1);
    grid->addWidget(browseButton, 0, 2);
    grid->addWidget(m_fileNote, 1, 1, 1, 2);
    return grid;
}

QWidget* ExportDialog::makeButtons()
{
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_export = buttons->addButton(tr("Export"), QDialogButtonBox::AcceptRole);
    m_export->setObjectName(u"exportButton"_s);
    connect(buttons, &QDialogButtonBox::accepted, this, &ExportDialog::acceptChoice);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    return buttons;
}

/** The first of all when there is none of that name. */
void ExportDialog::chooseFormat(const std::string& id)
{
    int chosen = 1; // below the first head
    for (int row = 0; row < m_formats->count(); ++row)
        if (m_formats->item(row)->data(Qt::UserRole).toString().toStdString() == id && !id.empty())
            chosen = row;
    m_formats->setCurrentRow(chosen);
}

const ExportFormat& ExportDialog::format() const
{
    const QListWidgetItem* item = m_formats->currentItem();
    const ExportFormat* chosen =
        item == nullptr ? nullptr
                        : findExportFormat(item->data(Qt::UserRole).toString().toStdString());
    return chosen == nullptr ? exportFormats().front() : *chosen;
}

void ExportDialog::showFormat()
{
    const ExportFormatText text = exportFormatText(format());
    m_about->setText(u"<b>%1 · %2</b><br>%3"_s.arg(
        text.name.toHtmlEscaped(), text.tool.toHtmlEscaped(), text.about.toHtmlEscaped()));
    m_options->showFormat(format());
    const bool isSuggested = m_path->text() == m_suggested;
    m_suggested = suggestedPath();
    m_path->setText(isSuggested ? m_suggested : withEnding(m_path->text(), format().extension));
    request();
}

/** Several formats of one ending have names of their own, so that none takes another's place. */
QString ExportDialog::suggestedPath() const
{
    const std::string_view id = format().id.substr(0, format().id.find('-'));
    const auto sharing =
        std::ranges::count(exportFormats(), format().extension, &ExportFormat::extension);
    const bool isNamed = sharing > 1 && id != format().extension;
    QString path = withEnding(m_offer.suggested.path, format().extension);
    if (!isNamed)
        return path;
    const QString ending = u'.' + stringOf(format().extension);
    return path.chopped(ending.size()) + u'-' + stringOf(id) + ending;
}

/** At once, or when it is known that it can be. */
void ExportDialog::acceptChoice()
{
    if (isUsable())
        return accept();
    request();
    m_isAccepted = true;
}

/** A preview of an earlier request is not to be taken for this one. */
bool ExportDialog::isUsable() const
{
    return m_preview && m_preview->request == choice() && !m_preview->error;
}

void ExportDialog::request()
{
    m_pathPause->stop();
    m_isAccepted = false;
    m_runner.requestExportPreview(choice());
    showState();
}

void ExportDialog::take(const ExportPreviewPointer& preview)
{
    if (preview->request != choice())
        return; // a newer preview follows
    m_preview = preview;
    if (!preview->error)
        m_view->showPreview(preview);
    showNotes(*preview);
    showState();
    if (m_isAccepted && m_export->isEnabled())
        accept();
}

/** Findings and changes first. */
void ExportDialog::showNotes(const ExportPreview& preview)
{
    QStringList lines;
    if (preview.error)
        lines << noteLine(tr("Not possible"), exportRefusalText(*preview.error));
    for (const ExportEffect effect :
         {ExportEffect::Check, ExportEffect::Changed, ExportEffect::LeftOut, ExportEffect::Note})
        for (const ExportNote& note : preview.notes)
            if (effectOf(note.kind) == effect)
                lines << noteLine(exportEffectText(effect), exportNoteText(note, locale()));
    m_notes->setText(lines.isEmpty() ? tr("Nothing was changed or left out.")
                                     : lines.join(u"<br>"_s));
}

/** Returns the reason that the file cannot be written; empty if it can. */
QString ExportDialog::fileFault() const
{
    const QFileInfo file(m_path->text());
    if (m_path->text().isEmpty() || file.isDir())
        return tr("Name the file.");
    if (!file.dir().exists())
        return issueSentence(IssueId::NoFolder, {file.dir().path().toStdString()});
    return {};
}

/** Shows the path, and whether a file exists there. */
QString ExportDialog::filesText() const
{
    QStringList names;
    bool anyThere = false;
    for (const QString& path : m_preview->paths) {
        const QFileInfo file(path);
        anyThere = anyThere || file.exists();
        names << file.fileName();
    }
    const QString folder = QFileInfo(m_path->text()).absolutePath();
    const QString size = locale().formattedDataSize(static_cast<qint64>(m_preview->bytes));
    QString text = tr("%1, %2, to %3").arg(names.join(u", "_s), size, folder);
    if (anyThere)
        text += u". "_s + tr("The file exists. Bergwatch asks before it overwrites it.");
    return text;
}

/** Enables the buttons that are possible now. */
void ExportDialog::showState()
{
    const QString fault = fileFault();
    const bool isCurrent = m_preview && m_preview->request == choice();
    m_view->setEnabled(isUsable());
    m_export->setEnabled((isUsable() || !isCurrent) && fault.isEmpty());
    if (!fault.isEmpty())
        m_fileNote->setText(fault);
    else if (!isCurrent)
        m_fileNote->setText(tr("Working ..."));
    else
        m_fileNote->setText(isUsable() ? filesText() : QString());
}

void ExportDialog::browse()
{
    const ExportFormatText text = exportFormatText(format());
    const QString filter = u"%1 (*.%2)"_s.arg(text.name, stringOf(format().extension));
    // The window asks itself before a file is replaced.
    const QString path = QFileDialog::getSaveFileName(this, tr("Export to"), m_path->text(), filter,
                                                      nullptr, QFileDialog::DontConfirmOverwrite);
    if (!path.isEmpty())
        m_path->setText(withEnding(path, format().extension));
}

ExportRequest ExportDialog::choice() const
{
    return {.formatId = std::string(format().id),
            .options = m_options->options(),
            .path = m_path->text()};
}

} // namespace berg
