#include "app/interaction.h"

#include "app/export_dialog.h"

#include <QCoreApplication>
#include <QFileDialog>
#include <QMessageBox>

using namespace Qt::StringLiterals;

namespace berg {
namespace {

struct Dialogs
{
    Q_DECLARE_TR_FUNCTIONS(Dialogs)
};

} // namespace

Interaction::Unsaved DialogInteraction::askUnsaved(QWidget* parent, const QString& name)
{
    QMessageBox box(QMessageBox::Question, Dialogs::tr("Unsaved changes"),
                    Dialogs::tr("Save the changes to \"%1\"?").arg(name),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, parent);
    box.setInformativeText(Dialogs::tr("They are lost if you do not save them."));
    box.setDefaultButton(QMessageBox::Save);
    switch (box.exec()) {
    case QMessageBox::Save:
        return Unsaved::Save;
    case QMessageBox::Discard:
        return Unsaved::Discard;
    default:
        return Unsaved::Cancel;
    }
}

QString DialogInteraction::openPath(QWidget* parent, const QString& filter)
{
    return QFileDialog::getOpenFileName(parent, Dialogs::tr("Open"), {}, filter);
}

QString DialogInteraction::savePath(QWidget* parent, const QString& suggested,
                                    const QString& filter)
{
    QFileDialog dialog(parent, Dialogs::tr("Save"), {}, filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    // Added by the dialog, so that its question about an existing file is about the right one.
    dialog.setDefaultSuffix(filter.section(u"(*."_s, 1, 1).section(u')', 0, 0));
    dialog.selectFile(suggested);
    if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty())
        return {};
    return dialog.selectedFiles().front();
}

std::optional<ExportChoice> DialogInteraction::chooseExport(QWidget* parent,
                                                            const ExportOffer& offer)
{
    ExportDialog dialog(offer, parent);
    if (dialog.exec() != QDialog::Accepted)
        return std::nullopt;
    return dialog.choice();
}

void DialogInteraction::showError(QWidget* parent, const QString& text)
{
    QMessageBox::warning(parent, Dialogs::tr("Bergwatch"), text);
}

void DialogInteraction::showInformation(QWidget* parent, const QString& title, const QString& html)
{
    QMessageBox box(QMessageBox::NoIcon, title, html, QMessageBox::Close, parent);
    box.setTextFormat(Qt::RichText);
    box.exec();
}

} // namespace berg
