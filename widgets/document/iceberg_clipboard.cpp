#include "widgets/document/iceberg_clipboard.h"

#include "core/io/files/iceberg_json.h"

#include <QCoreApplication>

using namespace Qt::StringLiterals;

namespace berg {

std::unique_ptr<QMimeData> icebergMimeData(std::span<const Iceberg> icebergs)
{
    const QByteArray text = QByteArray::fromStdString(icebergsToJson(icebergs));
    auto data = std::make_unique<QMimeData>();
    data->setData(QLatin1String(kIcebergMimeType), text);
    data->setText(QString::fromUtf8(text));
    return data;
}

std::vector<Iceberg> icebergsOf(const QMimeData* data)
{
    const QString type = QLatin1String(kIcebergMimeType);
    QByteArray text;
    if (data != nullptr)
        text = data->hasFormat(type) ? data->data(type) : data->text().toUtf8();
    const QString subject = QCoreApplication::translate("IcebergClipboard", "The clipboard");
    return icebergsFromJson(text.toStdString(), subject.toStdString());
}

} // namespace berg
