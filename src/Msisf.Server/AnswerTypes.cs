using System.Text.Json;
using System.Text.Json.Serialization;
using Msisf.App.Illumination;

namespace Msisf.Server;

/// <summary>
/// The types that go into JSON. Their members are known when the program is compiled: one that is compiled ahead of time has no others.
/// </summary>
[JsonSerializable(typeof(CratersAnswer))]
[JsonSerializable(typeof(FoldersAnswer))]
[JsonSerializable(typeof(FramesAnswer))]
[JsonSerializable(typeof(HeightsAnswer))]
[JsonSerializable(typeof(ModelsAnswer))]
[JsonSerializable(typeof(MonthOfLight))]
[JsonSerializable(typeof(NamesAnswer))]
[JsonSerializable(typeof(PixelsAnswer))]
[JsonSerializable(typeof(ProblemText))]
[JsonSerializable(typeof(StatesAnswer))]
[JsonSerializable(typeof(StreamError))]
[JsonSerializable(typeof(StreamReady))]
[JsonSerializable(typeof(SunAnswer))]
[JsonSerializable(typeof(SunPathAnswer))]
[JsonSerializable(typeof(SurfacePointsAnswer))]
[JsonSerializable(typeof(long))]
[JsonSerializable(typeof(Dictionary<string, double>))]
[JsonSerializable(typeof(Dictionary<string, string>))]
[JsonSerializable(typeof(Dictionary<string, JsonElement>))]
internal sealed partial class AnswerTypes : JsonSerializerContext;
