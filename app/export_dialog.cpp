#include "app/export_dialog.h"

#include "core/io/formats.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr int kFormatsWidth_px = 200;
constexpr int kAboutWidth_px = 360;

QString stringOf(std::string_view text)
{
    return QString::fromUtf8(text.data(), qsizetype(text.size()));
}

/** What one format is for, in the words of the dialog. */
struct FormatText
{
    QString tool;
    QString plan; ///< what the file holds
    QString run;  ///< once something was flown, if that is something else
};

FormatText textOf(const ExportFormat& format)
{
    if (format.id == "plan")
        return {.tool = u"QGroundControl"_s,
                .plan = ExportDialog::tr(
                    "Mission plan (.plan): one waypoint for each iceberg in the planned order, "
                    "then a loiter; home, speed and altitude. Also read by Mission Planner and "
                    "MAVSDK."),
                .run = ExportDialog::tr(
                    "Mission plan (.plan): one waypoint for each iceberg in the order they were "
                    "reached, then a loiter. Also read by Mission Planner and MAVSDK.")};
    if (format.id == "wpl")
        return {.tool = u"ArduPilot"_s,
                .plan = ExportDialog::tr(
                    "Waypoint list (.waypoints, QGC WPL 110) of the planned order, its first row "
                    "home, for Mission Planner and MAVProxy."),
                .run = ExportDialog::tr(
                    "Waypoint list (.waypoints, QGC WPL 110) of the icebergs in the order they "
                    "were reached, its first row home.")};
    if (format.id == "geojson")
        return {.tool = ExportDialog::tr("Maps (QGIS)"),
                .plan = ExportDialog::tr(
                    "GeoJSON with icebergs, UAV and planned legs as layers, WGS 84 longitude and "
                    "latitude."),
                .run = ExportDialog::tr(
                    "GeoJSON with icebergs, UAV and the track that was flown, WGS 84 longitude "
                    "and latitude.")};
    if (format.id == "csv")
        return {.tool = ExportDialog::tr("Spreadsheets"),
                .plan = ExportDialog::tr(
                    "Table (.csv) of the planned order: leg, distance, arrival and uncertainty of "
                    "each iceberg. Decimal points, UTF-8."),
                .run = ExportDialog::tr(
                    "Table (.csv) of the flown track: time, position, heading, turn rate and "
                    "cross-track error at each sample. Decimal points, UTF-8.")};
    return {.tool = stringOf(format.id), .plan = stringOf(format.reader), .run = {}};
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

} // namespace

ExportDialog::ExportDialog(const ExportOffer& offer, QWidget* parent)
    : QDialog(parent), m_offer(offer)
{
    setWindowTitle(tr("Export"));
    new QVBoxLayout(this);
    addFormats();
    addFile();
    addButtons();
    connect(m_formats, &QListWidget::currentRowChanged, this, &ExportDialog::showFormat);
    connect(m_path, &QLineEdit::textChanged, this, &ExportDialog::showFile);
    m_formats->setCurrentRow(0);
    for (int row = 0; row < m_formats->count(); ++row)
        if (m_formats->item(row)->data(Qt::UserRole).toString() == offer.formatId)
            m_formats->setCurrentRow(row);
}

void ExportDialog::addFormats()
{
    auto* row = new QHBoxLayout;
    row->setSpacing(16);
    m_formats = new QListWidget;
    m_formats->setObjectName(u"formatList"_s);
    m_formats->setAccessibleName(tr("Tool that reads the file"));
    m_formats->setFixedWidth(kFormatsWidth_px);
    for (const ExportFormat& format : exportFormats()) {
        auto* item = new QListWidgetItem(
            u"%1  (.%2)"_s.arg(textOf(format).tool, stringOf(format.extension)), m_formats);
        item->setData(Qt::UserRole, stringOf(format.id));
    }
    m_about = new QLabel;
    m_about->setObjectName(u"formatAbout"_s);
    m_about->setWordWrap(true);
    m_about->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    m_about->setMinimumSize(kAboutWidth_px, 120);
    row->addWidget(m_formats);
    row->addWidget(m_about, 1);
    qobject_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void ExportDialog::addFile()
{
    auto* row = new QHBoxLayout;
    m_path = new QLineEdit(m_offer.path);
    m_path->setObjectName(u"exportPath"_s);
    auto* label = new QLabel(tr("&File"));
    label->setBuddy(m_path);
    auto* browseButton = new QPushButton(tr("&Browse..."));
    browseButton->setAutoDefault(false);
    connect(browseButton, &QPushButton::clicked, this, &ExportDialog::browse);
    row->addWidget(label);
    row->addWidget(m_path, 1);
    row->addWidget(browseButton);
    qobject_cast<QVBoxLayout*>(layout())->addLayout(row);
    m_note = new QLabel;
    m_note->setObjectName(u"exportNote"_s);
    m_note->setWordWrap(true);
    layout()->addWidget(m_note);
}

void ExportDialog::addButtons()
{
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_export = buttons->addButton(tr("Export"), QDialogButtonBox::AcceptRole);
    m_export->setObjectName(u"exportButton"_s);
    m_export->setDefault(true);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    layout()->addWidget(buttons);
}

QString ExportDialog::formatId() const
{
    const QListWidgetItem* item = m_formats->currentItem();
    return item == nullptr ? QString() : item->data(Qt::UserRole).toString();
}

void ExportDialog::showFormat()
{
    const ExportFormat* format = findExportFormat(formatId().toStdString());
    if (format == nullptr)
        return;
    const FormatText text = textOf(*format);
    m_about->setText(u"<p><b>%1</b></p><p>%2</p>"_s.arg(
        text.tool.toHtmlEscaped(),
        (m_offer.flown && !text.run.isEmpty() ? text.run : text.plan).toHtmlEscaped()));
    m_path->setText(withEnding(m_path->text(), format->extension));
    showFile();
}

void ExportDialog::showFile()
{
    const QFileInfo file(m_path->text());
    const bool folderThere = file.dir().exists();
    const bool named = !m_path->text().isEmpty() && !file.isDir();
    m_export->setEnabled(named && folderThere);
    m_export->setText(named && file.exists() ? tr("Replace") : tr("Export"));
    if (!named)
        m_note->setText(tr("Name the file."));
    else if (!folderThere)
        m_note->setText(tr("There is no folder %1.").arg(file.dir().path()));
    else if (file.exists())
        m_note->setText(tr("The file exists and will be replaced."));
    else
        m_note->setText(tr("Goes to %1").arg(file.dir().absolutePath()));
}

void ExportDialog::browse()
{
    const ExportFormat* format = findExportFormat(formatId().toStdString());
    if (format == nullptr)
        return;
    const QString filter = u"%1 (*.%2)"_s.arg(textOf(*format).tool, stringOf(format->extension));
    // The dialog here says itself when a file would be replaced.
    const QString path = QFileDialog::getSaveFileName(this, tr("Export to"), m_path->text(), filter,
                                                      nullptr, QFileDialog::DontConfirmOverwrite);
    if (!path.isEmpty())
        m_path->setText(withEnding(path, format->extension));
}

ExportChoice ExportDialog::choice() const
{
    return {.formatId = formatId(), .path = m_path->text()};
}

} // namespace berg
