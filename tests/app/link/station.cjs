// A ground station for `bergwatch-cli vehicle`: node station.cjs PORT ardupilot|px4
// It does what ground stations do at connect and in use, says what fails, and ends with 1 then.
'use strict';
const {NodeLink, minimal, common} = require('./node_link.cjs');
const [port, kind] = process.argv.slice(2);
const isPx4 = kind === 'px4';
const heard = []; // messages of the vehicle, newest last
const to = {targetSystem: 1, targetComponent: 1};
let answer = () => {}; // reaction to a message of the vehicle

const link = new NodeLink({port: +port, system: 255, component: 190, onMessage: (message, header) => {
    if (header.sysid !== 1)
        return;
    heard.push(message);
    answer(message);
}});
const beat = () => link.send(minimal.Heartbeat, {type: 6, autopilot: 8, systemStatus: 4, mavlinkVersion: 3});
setInterval(beat, 1000);

// Repeats `act` every second until `isDone` holds for a message heard since; fails after 30 s.
function awaited(what, act, isDone) {
    const from = heard.length;
    return new Promise((resolve, reject) => {
        let tries = 0;
        const next = () => {
            if (++tries > 30)
                return reject(new Error(`no ${what}`));
            act();
            setTimeout(next, 1000);
        };
        const look = setInterval(() => {
            const found = heard.slice(from).find(isDone);
            if (!found)
                return;
            clearInterval(look);
            tries = 30; // ends the repetition
            console.log(`${what}: yes`);
            resolve(found);
        }, 20);
        next();
    });
}
const is = (message, name) => message.constructor.MSG_NAME === name;
const check = (what, isTrue) => {
    if (!isTrue)
        throw new Error(what);
};
const command = (id, params) => link.send(common.CommandLong, {...to, command: id, ...params});

function missionItems(count) {
    const items = [];
    for (let i = 0; i < count; ++i)
        items.push({seq: i, frame: 3, command: 16, current: i === 0 ? 1 : 0, autocontinue: 1, param1: 0,
                    param2: 25, param3: 0, param4: NaN, x: 470000000 + 1000 * i, y: -480000000 + 700 * i, z: 120});
    return items;
}

async function upload(items, missionType) {
    const asked = new Set();
    answer = message => {
        if ((is(message, 'MISSION_REQUEST') || is(message, 'MISSION_REQUEST_INT')) && items[message.seq]) {
            asked.add(message.constructor.MSG_NAME);
            link.send(common.MissionItemInt, {...to, ...items[message.seq], missionType});
        }
    };
    const ack = await awaited(`upload of list ${missionType}`,
        () => link.send(common.MissionCount, {...to, count: items.length, missionType}),
        message => is(message, 'MISSION_ACK') && message.missionType === missionType);
    answer = () => {};
    check(`upload is accepted, not ${ack.type}`, ack.type === 0);
    check('the autopilot asks with its own message',
          [...asked].join() === (isPx4 ? 'MISSION_REQUEST_INT' : 'MISSION_REQUEST'));
}

async function download(missionType) {
    const {count} = await awaited(`count of list ${missionType}`,
        () => link.send(common.MissionRequestList, {...to, missionType}),
        message => is(message, 'MISSION_COUNT') && message.missionType === missionType);
    const items = [];
    for (let seq = 0; seq < count; ++seq)
        items.push(await awaited(`item ${seq}`,
            () => link.send(common.MissionRequestInt, {...to, seq, missionType}),
            message => is(message, 'MISSION_ITEM_INT') && message.seq === seq));
    link.send(common.MissionAck, {...to, type: 0, missionType});
    return items;
}

async function main() {
    const first = await awaited('heartbeat', beat, message => is(message, 'HEARTBEAT'));
    check('autopilot', first.autopilot === (isPx4 ? 12 : 3) && first.type === 1);
    const version = await awaited('version', () => command(512, {_param1: 148}),
                                  message => is(message, 'AUTOPILOT_VERSION'));
    check('capabilities', (Number(version.capabilities) & 8196) === 8196);
    await awaited('answer to what it does not send', () => command(512, {_param1: 300}),
                  message => is(message, 'COMMAND_ACK') && message.command === 512 && message.result === 3);
    await awaited('refusal to arm', () => command(400, {_param1: 1}),
                  message => is(message, 'COMMAND_ACK') && message.command === 400 && message.result === 2);
    const parameter = await awaited('parameter', () => link.send(common.ParamRequestList, to),
                                    message => is(message, 'PARAM_VALUE'));
    for (let index = 0; index < parameter.paramCount; ++index)
        await awaited(`parameter ${index}`, () => link.send(common.ParamRequestList, to),
                      message => is(message, 'PARAM_VALUE') && message.paramIndex === index);
    await awaited('position', () => command(511, {_param1: 33, _param2: 200000}),
                  message => is(message, 'GLOBAL_POSITION_INT') && message.lat !== 0);

    const items = missionItems(14);
    await upload(items, 0);
    const onBoard = await download(0);
    check('number of items', onBoard.length === 14);
    onBoard.forEach((item, seq) => {
        if (seq > 0 || isPx4) // ArduPilot puts home in place of item 0
            check(`item ${seq} is as sent`, item.x === items[seq].x && item.y === items[seq].y &&
                  item.z === 120 && item.param2 === 25 && item.command === 16);
    });
    const fence = [0, 1, 2].map(i => ({seq: i, frame: 0, command: 5001, current: 0, autocontinue: 1, param1: 3,
        param2: 0, param3: 0, param4: 0, x: 470000000 + 90000 * (i % 2), y: -480000000 + 90000 * i, z: 0}));
    await upload(fence, 1);
    check('fence on board', (await download(1)).length === 3);
    await upload([{seq: 0, frame: 3, command: 5100, current: 0, autocontinue: 1, param1: 0, param2: 0, param3: 0,
                   param4: 0, x: 470000000, y: -480000000, z: 100}], 2);
    check('rally point on board', (await download(2)).length === 1);

    // Automatic flight of the mission.
    const auto = isPx4 ? 0x04040000 : 10;
    await awaited('mode', () => command(176, isPx4 ? {_param1: 1, _param2: 4, _param3: 4} : {_param1: 1, _param2: 10}),
                  message => is(message, 'HEARTBEAT') && message.customMode === auto);
    await awaited('place', () => link.send(common.CommandInt, {...to, command: 192, frame: 3, _param1: -1, _param2: 1,
                                            _param3: 300, _param4: NaN, _param5: 470100000, _param6: -480100000,
                                            _param7: 120}),
                  message => is(message, 'COMMAND_ACK') && message.command === 192 && message.result === 0);
}

main().then(() => process.exit(0), error => {
    console.error(String(error));
    process.exit(1);
});
