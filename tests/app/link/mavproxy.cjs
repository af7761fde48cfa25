// A ground station for `bergwatch-cli vehicle` that behaves like MAVProxy: node mavproxy.cjs PORT ardupilot|px4
// MAVProxy addresses component 0, reads lists with five requests under way and without an acknowledgement, sends a
// count once, and answers MISSION_REQUEST only. It says what fails, and ends with 1 then.
'use strict';
const {NodeLink, minimal, common} = require('./node_link.cjs');
const [port, kind] = process.argv.slice(2);
const isPx4 = kind === 'px4';
const to = {targetSystem: 1, targetComponent: 0};
const self = {system: 255, component: 230};
let heard = [];
let answer = () => {};

const link = new NodeLink({port: +port, ...self, onMessage: (message, header) => {
    if (header.sysid !== 1)
        return;
    heard.push(message);
    answer(message);
}});
const beat = () => link.send(minimal.Heartbeat, {type: 6, autopilot: 8, systemStatus: 4, mavlinkVersion: 3});
setInterval(beat, 1000);

const is = (message, name) => message.constructor.MSG_NAME === name;
const check = (what, isTrue) => {
    if (!isTrue)
        throw new Error(what);
    console.log(`${what}: yes`);
};
const pause = ms => new Promise(resolve => setTimeout(resolve, ms));
const command = (id, params) => link.send(common.CommandLong, {...to, command: id, ...params});

// Waits for a message, at most 30 s.
async function until(what, isDone) {
    for (let tries = 0; tries < 1500; ++tries) {
        const found = heard.find(isDone);
        if (found) {
            console.log(`${what}: yes`);
            return found;
        }
        await pause(20);
    }
    throw new Error(`no ${what}`);
}

async function load(what, items, missionType) {
    heard = [];
    answer = message => {
        if (is(message, 'MISSION_REQUEST') && message.missionType === missionType && items[message.seq] &&
            message.targetSystem === self.system && message.targetComponent === self.component)
            link.send(common.MissionItemInt, {...to, ...items[message.seq], missionType});
    };
    link.send(common.MissionCount, {...to, count: items.length, missionType});
    const ack = await until(`${what} load`, message => is(message, 'MISSION_ACK') && message.missionType === missionType);
    answer = () => {};
    check(`${what} load is accepted, not ${ack.type}`, ack.type === 0);
}

async function list(what, missionType) {
    heard = [];
    const items = new Map();
    const asked = new Set();
    let count = -1;
    answer = message => {
        if (message.missionType !== missionType)
            return;
        if (is(message, 'MISSION_COUNT'))
            count = message.count;
        else if (is(message, 'MISSION_ITEM_INT'))
            items.set(message.seq, message);
        else
            return;
        for (let seq = items.size; seq < Math.min(items.size + 5, count); ++seq)
            if (!asked.has(seq)) {
                asked.add(seq);
                link.send(common.MissionRequestInt, {...to, seq, missionType});
            }
    };
    link.send(common.MissionRequestList, {...to, missionType});
    await until(`${what} list`, () => count >= 0 && items.size === count);
    answer = () => {};
    if (isPx4)
        await pause(6000); // it waits 5 s for an acknowledgement, which does not come
    return [...items.keys()].sort((a, b) => a - b).map(seq => items.get(seq));
}

const item = (seq, fields) => ({seq, frame: 3, command: 16, current: 0, autocontinue: 1, param1: 0, param2: 0,
                                param3: 0, param4: 0, x: 470000000, y: -480000000, z: 100, ...fields});

async function main() {
    beat();
    const first = await until('heartbeat', message => is(message, 'HEARTBEAT'));
    check('flags of an automatic mode', (first.baseMode & 28) === 28);
    link.send(common.RequestDataStream, {...to, reqStreamId: 0, reqMessageRate: 4, startStop: 1});
    for (const name of ['GLOBAL_POSITION_INT', 'ATTITUDE', 'VFR_HUD', 'SYS_STATUS', 'GPS_RAW_INT', 'MISSION_CURRENT'])
        await until(name, message => is(message, name));
    link.send(common.ParamRequestList, to);
    const parameter = await until('parameter', message => is(message, 'PARAM_VALUE'));
    await until('last parameter',
                message => is(message, 'PARAM_VALUE') && message.paramIndex === parameter.paramCount - 1);
    command(520, {_param1: 1, _param2: 1});
    const version = await until('version', message => is(message, 'AUTOPILOT_VERSION'));
    check('fence and rally points by the mission protocol', (Number(version.capabilities) & 49152) === 49152);
    command(410, {});
    await until('home', message => is(message, 'HOME_POSITION'));

    check('no mission', (await list('wp', 0)).length === 0);
    const mission = [];
    for (let seq = 0; seq < 14; ++seq)
        mission.push(item(seq, {x: 470000000 + 1000 * seq, y: -480000000 + 700 * seq, z: 120, param2: 25}));
    await load('wp', mission, 0);
    const onBoard = await list('wp', 0);
    check('items on board', onBoard.length === 14 && onBoard.every((got, seq) =>
        (seq === 0 && !isPx4) || (got.x === mission[seq].x && got.y === mission[seq].y && got.z === 120)));
    const fence = [0, 1, 2].map(i => item(i, {frame: 0, command: 5001, param1: 3, x: 470000000 + 90000 * (i % 2),
                                              y: -480000000 + 90000 * i, z: 0}));
    await load('fence', fence, 1);
    check('fence on board', (await list('fence', 1)).length === 3);
    await load('rally', [item(0, {command: 5100})], 2);
    check('rally point on board', (await list('rally', 2)).length === 1);
    heard = [];
    link.send(common.MissionClearAll, {...to, missionType: 1});
    await until('fence clear', message => is(message, 'MISSION_ACK') && message.type === 0);
    check('no fence', (await list('fence', 1)).length === 0);

    heard = [];
    command(224, {_param1: 5});
    await until('wp set', message => is(message, 'COMMAND_ACK') && message.command === 224 && message.result === 0);
    link.send(common.MissionSetCurrent, {targetSystem: 1, targetComponent: 0, seq: 7});
    await until('wp set by the older message', message => is(message, 'MISSION_CURRENT') && message.seq === 7);
    for (const [name, params, mode] of isPx4 ? [['RTL', {_param1: 29, _param2: 4, _param3: 5}, 0x05040000],
                                                ['MISSION', {_param1: 29, _param2: 4, _param3: 4}, 0x04040000]]
                                             : [['RTL', {_param1: 1, _param2: 11}, 11],
                                                ['AUTO', {_param1: 1, _param2: 10}, 10]]) {
        command(176, params);
        await until(`mode ${name}`, message => is(message, 'HEARTBEAT') && message.customMode === mode);
    }
}

main().then(() => process.exit(0), error => {
    console.error(String(error));
    process.exit(1);
});
