// SPDX-License-Identifier: MIT
// A viewer that uses the Foxglove WebSocket protocol. It subscribes to all channels and decodes every message. After
// `packets` robot states or `seconds`, it prints the received data as JSON.
// node viewer.mjs NODE_MODULES URL PACKETS SECONDS
import { createRequire } from "node:module";
const [, , modules, url, packets, seconds] = process.argv;
const load = createRequire(modules + "/");
const WebSocket = load("ws");
const { parse } = load("@foxglove/rosmsg");
const { MessageReader } = load("@foxglove/rosmsg2-serialization");

const socket = new WebSocket(url, ["foxglove.sdk.v1"]);
const topics = new Map();
const found = { topics: {}, protocol: "", name: "", statuses: [] };
const states = [];
function end() {
  const stamps = states.map((state) => state.timestamp);
  found.gaps = stamps.slice(1).filter((stamp, i) => Math.abs(stamp - stamps[i] - 0.002) > 0.0005).length;
  found.lost = states.reduce((sum, state) => sum + Number(state.packages_lost), 0);
  found.last = states.at(-1);
  const plain = (key, value) =>
    typeof value === "bigint" ? value.toString() : ArrayBuffer.isView(value) ? Array.from(value) : value;
  console.log(JSON.stringify(found, plain));
  process.exit(0);
}
setTimeout(end, Number(seconds) * 1000);
socket.on("error", (error) => { console.error(error.message); process.exit(1); });
socket.on("close", end);
socket.on("open", () => { found.protocol = socket.protocol; });
socket.on("message", (data, isBinary) => {
  if (!isBinary) {
    const message = JSON.parse(data.toString());
    if (message.op === "serverInfo") {
      found.name = message.name;
    } else if (message.op === "status") {
      found.statuses.push(message.message);
    } else if (message.op === "advertise") {
      for (const channel of message.channels) {
        const decoder = new MessageReader(parse(channel.schema, { ros2: true }));
        topics.set(channel.id, { topic: channel.topic, decoder });
        found.topics[channel.topic] = { encoding: channel.encoding, schema: channel.schemaName, count: 0 };
      }
      const subscriptions = message.channels.map((channel) => ({ id: channel.id, channelId: channel.id }));
      socket.send(JSON.stringify({ op: "subscribe", subscriptions }));
      if (message.channels.some((channel) => channel.topic === "/robot_state")) {
        console.error("subscribed");
      }
    }
    return;
  }
  if (data.readUInt8(0) !== 1) {
    return;
  }
  const { topic, decoder } = topics.get(data.readUInt32LE(1));
  const decoded = decoder.readMessage(new Uint8Array(data.subarray(13)));
  found.topics[topic].count++;
  found.time = data.readBigUInt64LE(5);
  if (topic === "/robot_state") {
    states.push(decoded);
  }
  if (states.length >= Number(packets) && found.topics["/tf"].count >= states.length) {
    end();
  }
});
