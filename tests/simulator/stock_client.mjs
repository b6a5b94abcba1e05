// Stock roslibjs against a server: does what standard input asks for, prints what came back as JSON.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

const folder = process.argv[2];
const resolved = createRequire(pathToFileURL(`${folder}/package.json`));
const entry = `${folder}/node_modules/roslib/${resolved("./node_modules/roslib/package.json").module}`;
const { Ros, Service, Topic } = await import(pathToFileURL(entry).href);

const asked = JSON.parse(readFileSync(0, "utf8"));
const ros = new Ros();
await ros.connect(asked.url);

const answer = (name, args) =>
  new Promise((done) => {
    const service = new Service({ ros, name, serviceType: "" });
    service.callService(args, (values) => done([true, values]), (error) => done([false, error]));
  });

const firstMessage = (name, messageType) =>
  new Promise((done) => {
    const topic = new Topic({ ros, name, messageType, queue_length: 1 });
    topic.subscribe((message) => {
      topic.unsubscribe();
      done(message);
    });
  });

const found = { answers: {}, messages: {} };
for (const call of asked.calls) found.answers[call.id] = await answer(call.service, call.args);
for (const [topic, type] of Object.entries(asked.topics)) found.messages[topic] = await firstMessage(topic, type);

const talker = new Topic({ ros, name: "/chatter", messageType: asked.string, latch: true });
talker.advertise();
talker.publish({ data: "hello" });
found.echo = await firstMessage("/chatter", asked.string);

const own = new Service({ ros, name: "/own_service", serviceType: asked.set_bool });
await own.advertise((request, response) => {
  response.success = request.data;
  response.message = "done";
  return true;
});
found.served = await answer("/own_service", { data: true });

const [first] = Object.keys(asked.topics);
found.topic_type = await new Promise((done) => ros.getTopicType(first, done));
found.nodes = await new Promise((done) => ros.getNodes(done));
found.fields = await new Promise((done) =>
  ros.getMessageDetails(asked.pose, (details) => done(details[0].fieldnames)),
);
process.stdout.write(JSON.stringify(found), () => process.exit(0));
