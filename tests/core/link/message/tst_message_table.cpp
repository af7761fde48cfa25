#include "core/link/message/link_frame.h"
#include "core/link/message/message_table.h"

#include <QtTest>

using namespace berg;

namespace {

std::uint16_t continued(std::uint16_t crc, std::string_view text)
{
    const std::vector<std::uint8_t> bytes(text.begin(), text.end());
    return linkChecksum(bytes, crc);
}

/** MAVLink's rule: name, then type and name of each base field, and the length of arrays. */
int crcExtraOf(const MessageSpec& spec)
{
    std::uint16_t crc = continued(0xFFFF, spec.name + ' ');
    for (const MessageField& field : spec.fields) {
        if (field.isExtension)
            continue;
        crc = continued(crc, wireNameOf(field.type) + ' ' + field.name + ' ');
        const auto count = static_cast<std::uint8_t>(field.count);
        if (field.count > 0)
            crc = linkChecksum(std::span(&count, 1), crc);
    }
    return (crc & 0xFF) ^ (crc >> 8);
}

} // namespace

class TestMessageTable : public QObject
{
    Q_OBJECT

private slots:
    void checksumIsMcrf4xx() { QCOMPARE(continued(0xFFFF, "123456789"), std::uint16_t{0x6F91}); }

    void rowsAgreeWithTheRule()
    {
        QCOMPARE(messageSpecs().size(), std::size_t{48});
        for (const MessageSpec& spec : messageSpecs()) {
            QVERIFY2(crcExtraOf(spec) == spec.crcExtra, spec.name.c_str());
            std::size_t base = 0;
            std::size_t full = 0;
            std::size_t lastBytes = 8;
            for (const MessageField& field : spec.fields) {
                QVERIFY2(field.offset == full, (spec.name + '.' + field.name).c_str());
                full += bytesOf(field.type) * static_cast<std::size_t>(std::max(field.count, 1));
                if (field.isExtension)
                    continue;
                base = full;
                QVERIFY2(bytesOf(field.type) <= lastBytes, (spec.name + '.' + field.name).c_str());
                lastBytes = bytesOf(field.type); // base fields are sorted by the size of elements
            }
            QVERIFY2(base == spec.baseLength, spec.name.c_str());
            QVERIFY2(full == spec.fullLength && full <= 255, spec.name.c_str());
        }
    }

    void messagesAreFoundById()
    {
        QCOMPARE(findMessage(73)->name, "MISSION_ITEM_INT");
        QCOMPARE(findMessage(436)->name, "CURRENT_MODE");
        QVERIFY(findMessage(3) == nullptr);
        QVERIFY(findMessage(0xFFFFFF) == nullptr);
        for (const MessageSpec& spec : messageSpecs())
            QVERIFY(findMessage(spec.id) == &spec); // also proves that the ids ascend
    }
};

QTEST_APPLESS_MAIN(TestMessageTable)
#include "tst_message_table.moc"
