#include "app/dialogs/interaction.h"

#include "app/dialogs/export_dialog.h"
#include "app/dialogs/forecast_dialog.h"
#include "app/dialogs/import_dialog.h"
#include "app/dialogs/origin_dialog.h"
#include "app/dialogs/recovery_dialog.h"
#include "app/dialogs/screen_fit.h"
#include "app/dialogs/wind_dialog.h"
#include "widgets/theme/declination.h"

#include <QApplication>
#include <QCloseEvent>
#include <QCoreApplication>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QLabel>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSettings>
#include <QTimer>
#include <QVBoxLayout>

#include <chrono>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

constexpr const char* kFolderKey = "files/folder";

struct Dialogs
{
    Q_DECLARE_TR_FUNCTIONS(Dialogs)
};

/** Cannot be closed by who waits. */
class BusyDialog final : public QProgressDialog
{
public:
    using QProgressDialog::QProgressDialog;
    void reject() override {}

protected:
    void closeEvent(QCloseEvent* event) override { event->ignore(); }
};

QString consequence(Interaction::FlightEnd why)
{
    switch (why) {
    case Interaction::FlightEnd::Answer:
        return Dialogs::tr("The scenario can only be changed when no flight is in progress. The "
                           "flight stays in the list of runs.");
    case Interaction::FlightEnd::Other:
        return Dialogs::tr("What has been flown so far stays in the list of runs.");
    }
    return {};
}

Interaction::Unsaved unsavedAnswer(QMessageBox& box)
{
    box.setDefaultButton(QMessageBox::Save);
    box.button(QMessageBox::Discard)->setText(Dialogs::tr("&Discard"));
    switch (box.exec()) {
    case QMessageBox::Save:
        return Interaction::Unsaved::Save;
    case QMessageBox::Discard:
        return Interaction::Unsaved::Discard;
    default:
        return Interaction::Unsaved::Cancel;
    }
}

} // namespace

Interaction::Unsaved DialogInteraction::askUnsaved(QWidget* parent, const UnsavedWork& work)
{
    QMessageBox box(QMessageBox::Question, Dialogs::tr("Unsaved changes"),
                    Dialogs::tr("Save the changes to \"%1\"?").arg(work.name),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, parent);
    box.setInformativeText(work.endsFlight
                               ? Dialogs::tr("Your changes will be lost if you don't save them. "
                                             "The flight in progress ends unless you cancel.")
                               : Dialogs::tr("Your changes will be lost if you don't save them."));
    return unsavedAnswer(box);
}

Interaction::Unsaved DialogInteraction::askUnsavedRun(QWidget* parent, bool isUnderWay)
{
    QMessageBox box(QMessageBox::Question,
                    isUnderWay ? Dialogs::tr("Flight under way") : Dialogs::tr("Unsaved run"),
                    isUnderWay ? Dialogs::tr("Save the run before the flight ends?")
                               : Dialogs::tr("Save the run?"),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, parent);
    box.setInformativeText(Dialogs::tr("The flight will be lost if you don't save it."));
    box.button(QMessageBox::Save)->setText(Dialogs::tr("&Save run..."));
    return unsavedAnswer(box);
}

bool DialogInteraction::askEndFlight(QWidget* parent, FlightEnd why)
{
    QMessageBox box(QMessageBox::Question, Dialogs::tr("Flight under way"),
                    why == FlightEnd::Answer
                        ? Dialogs::tr("A flight has started in the meantime. End it?")
                        : Dialogs::tr("A flight is in progress. End it?"),
                    QMessageBox::NoButton, parent);
    box.setInformativeText(consequence(why));
    const QPushButton* end = box.addButton(Dialogs::tr("End the flight"), QMessageBox::AcceptRole);
    box.setDefaultButton(box.addButton(Dialogs::tr("Continue flight"), QMessageBox::RejectRole));
    box.exec();
    return box.clickedButton() == end;
}

QString DialogInteraction::openPath(QWidget* parent, const QString& filter)
{
    QString path = QFileDialog::getOpenFileName(parent, Dialogs::tr("Open"), lastFolder(), filter);
    rememberFolder(path);
    return path;
}

QString DialogInteraction::lastFolder() const
{
    return m_settings == nullptr ? QString() : m_settings->value(kFolderKey).toString();
}

void DialogInteraction::rememberFolder(const QString& path)
{
    if (m_settings != nullptr && !path.isEmpty())
        m_settings->setValue(kFolderKey, QFileInfo(path).absolutePath());
}

QString DialogInteraction::savePath(QWidget* parent, const QString& suggested,
                                    const QString& filter)
{
    QFileDialog dialog(parent, Dialogs::tr("Save"), lastFolder(), filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    // Added by the dialog, so that its question about an existing file is about the right one.
    const auto add = [&dialog](const QString& chosen) {
        if (const QString ending = chosen.section(u"(*."_s, 1, 1).section(u')', 0, 0);
            !ending.isEmpty()) // "All files" keep the one before
            dialog.setDefaultSuffix(ending);
    };
    add(filter);
    QObject::connect(&dialog, &QFileDialog::filterSelected, &dialog, add);
    dialog.selectFile(suggested);
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty())
        return {};
    rememberFolder(dialog.selectedFiles().front());
    return dialog.selectedFiles().front();
}

std::optional<OriginChoice> DialogInteraction::askOrigin(QWidget* parent, const Scenario& scenario,
                                                         const LatLon& suggested,
                                                         const Theme& theme)
{
    OriginDialog dialog(scenario, suggested, theme, parent);
    boundToScreen(dialog);
    if (dialog.exec() != QDialog::Accepted)
        return std::nullopt;
    return dialog.choice();
}

std::optional<ForecastChoice> DialogInteraction::askForecast(QWidget* parent,
                                                             const ForecastOffer& offer)
{
    ForecastDialog dialog(offer, parent);
    boundToScreen(dialog);
    if (dialog.exec() != QDialog::Accepted)
        return std::nullopt;
    return dialog.choice();
}

std::optional<Point> DialogInteraction::askWind(QWidget* parent, const Point& wind_mps,
                                                double airspeed_mps)
{
    WindDialog dialog(wind_mps, airspeed_mps, parent);
    if (dialog.exec() != QDialog::Accepted)
        return std::nullopt;
    return dialog.wind_mps();
}

std::optional<double> DialogInteraction::askDeclination(QWidget* parent, double present_deg)
{
    bool isAnswered = false;
    const double typed_deg = QInputDialog::getDouble(
        parent, Dialogs::tr("Magnetic declination"),
        Dialogs::tr("Degrees from true to magnetic north, positive east, negative west:"),
        present_deg, -kMostDeclination_deg, kMostDeclination_deg, 1, &isAnswered);
    return isAnswered ? std::optional(typed_deg) : std::nullopt;
}

std::optional<ExportRequest> DialogInteraction::chooseExport(QWidget* parent, MissionRunner& runner,
                                                             const ExportOffer& offer)
{
    ExportDialog dialog(runner, offer, parent);
    boundToScreen(dialog);
    if (dialog.exec() != QDialog::Accepted)
        return std::nullopt;
    return dialog.choice();
}

std::optional<ImportChoice> DialogInteraction::chooseImport(QWidget* parent, ImportRunner& runner,
                                                            const ImportOffer& offer)
{
    ImportDialog dialog(runner, offer, parent, m_settings);
    boundToScreen(dialog);
    if (dialog.exec() != QDialog::Accepted)
        return std::nullopt;
    return dialog.choice();
}

Interaction::InUse DialogInteraction::askInUse(QWidget* parent, const QString& fileName,
                                               const QString& holder)
{
    QMessageBox box(QMessageBox::Question, Dialogs::tr("File in use"),
                    Dialogs::tr("\"%1\" is open in another window.").arg(fileName),
                    QMessageBox::Cancel, parent);
    box.setInformativeText(
        Dialogs::tr("%1 has it open. You can open a copy and save it under another name. If both "
                    "windows save to this file, the last one wins.")
            .arg(holder));
    QPushButton* copy = box.addButton(Dialogs::tr("Open a copy"), QMessageBox::AcceptRole);
    const QPushButton* anyway =
        box.addButton(Dialogs::tr("Open anyway"), QMessageBox::DestructiveRole);
    box.setDefaultButton(copy);
    box.exec();
    if (box.clickedButton() == copy)
        return InUse::OpenCopy;
    return box.clickedButton() == anyway ? InUse::OpenAnyway : InUse::Cancel;
}

Interaction::Overwrite DialogInteraction::askOverwrite(QWidget* parent, const QString& fileName,
                                                       const QString& reason)
{
    QMessageBox box(QMessageBox::Warning, Dialogs::tr("Overwrite the file?"),
                    Dialogs::tr("Overwrite \"%1\"?").arg(fileName), QMessageBox::Cancel, parent);
    box.setInformativeText(reason);
    const QPushButton* overwrite =
        box.addButton(Dialogs::tr("Overwrite"), QMessageBox::DestructiveRole);
    QPushButton* saveAs = box.addButton(Dialogs::tr("Save as..."), QMessageBox::AcceptRole);
    box.setDefaultButton(saveAs);
    box.exec();
    if (box.clickedButton() == overwrite)
        return Overwrite::Overwrite;
    return box.clickedButton() == saveAs ? Overwrite::SaveAs : Overwrite::Cancel;
}

bool DialogInteraction::askRemove(QWidget* parent, const QStringList& names)
{
    QMessageBox box(
        QMessageBox::Question, Dialogs::tr("Remove icebergs"),
        Dialogs::tr("Remove %n icebergs from this run?", nullptr, static_cast<int>(names.size())),
        QMessageBox::NoButton, parent);
    box.setInformativeText(
        Dialogs::tr("%1: the UAV will not visit them any more.").arg(names.join(u", "_s)));
    QPushButton* remove = box.addButton(Dialogs::tr("&Remove"), QMessageBox::DestructiveRole);
    box.setDefaultButton(box.addButton(QMessageBox::Cancel));
    box.exec();
    return box.clickedButton() == remove;
}

bool DialogInteraction::askUndo(QWidget* parent, const QString& change, const QString& since)
{
    QMessageBox box(QMessageBox::Question, Dialogs::tr("Undo in flight"),
                    Dialogs::tr("Undo \"%1\" of %2?").arg(change, since), QMessageBox::NoButton,
                    parent);
    box.setInformativeText(
        Dialogs::tr("The flight goes back to that time and continues without the change. The "
                    "flight since then is discarded; \"Restore\" brings it back."));
    const QPushButton* undo = box.addButton(Dialogs::tr("&Undo"), QMessageBox::AcceptRole);
    box.setDefaultButton(box.addButton(QMessageBox::Cancel));
    box.exec();
    return box.clickedButton() == undo;
}

bool DialogInteraction::askReload(QWidget* parent, const QString& fileName)
{
    QMessageBox box(QMessageBox::Question, Dialogs::tr("File changed"),
                    Dialogs::tr("Another program has changed \"%1\".").arg(fileName),
                    QMessageBox::NoButton, parent);
    box.setInformativeText(Dialogs::tr("You have no unsaved changes."));
    QPushButton* reload = box.addButton(Dialogs::tr("Open it again"), QMessageBox::AcceptRole);
    box.addButton(Dialogs::tr("Keep what I see"), QMessageBox::RejectRole);
    box.setDefaultButton(reload);
    box.exec();
    return box.clickedButton() == reload;
}

RecoveryAnswer DialogInteraction::askRecovery(QWidget* parent,
                                              const std::vector<RecoveryOffer>& offers)
{
    RecoveryDialog dialog(offers, parent);
    boundToScreen(dialog);
    dialog.exec();
    return dialog.answer();
}

void DialogInteraction::showError(QWidget* parent, const QString& text)
{
    QMessageBox::warning(parent, Dialogs::tr("Bergwatch"), text);
}

void DialogInteraction::waitUntil(QWidget* parent, const QString& text,
                                  const std::function<bool()>& isDone, bool mayCancel)
{
    constexpr auto kPatience = std::chrono::milliseconds(500); // without a dialog that flickers
    QTimer patience;
    patience.setSingleShot(true);
    patience.start(kPatience);
    QTimer tick; // what is waited for need not be an event
    tick.start(std::chrono::milliseconds(20));
    const auto wait = [&](QEventLoop::ProcessEventsFlags which) {
        QCoreApplication::processEvents(which | QEventLoop::WaitForMoreEvents);
    };
    while (!isDone() && patience.isActive())
        wait(QEventLoop::ExcludeUserInputEvents);
    if (isDone())
        return;
    const auto dialog =
        mayCancel ? std::make_unique<QProgressDialog>(text, Dialogs::tr("Cancel"), 0, 0, parent)
                  : std::make_unique<BusyDialog>(text, QString(), 0, 0, parent);
    dialog->setWindowModality(Qt::WindowModal);
    dialog->show();
    while (!isDone() && !(mayCancel && dialog->wasCanceled()))
        wait(QEventLoop::AllEvents);
}

void DialogInteraction::showInformation(QWidget* parent, const QString& title, const QString& html)
{
    QDialog dialog(parent);
    dialog.setWindowTitle(title);
    auto* text = new QLabel(html);
    text->setTextFormat(Qt::RichText);
    text->setOpenExternalLinks(true);
    auto* scroll = new QScrollArea;
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidget(text);
    // The dialog is as large as its text if the screen has room; otherwise it scrolls.
    const int bar_px = scroll->verticalScrollBar()->sizeHint().width();
    scroll->setMinimumSize(
        (text->sizeHint() + QSize(bar_px, 0)).boundedTo(dialog.screen()->availableSize() * 4 / 5));
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    auto* layout = new QVBoxLayout(&dialog);
    layout->addWidget(scroll);
    layout->addWidget(buttons);
    dialog.exec();
}

void DialogInteraction::soundAlarm()
{
    QApplication::beep();
}

} // namespace berg
