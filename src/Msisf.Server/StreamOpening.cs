using System.Text.Json;
using Msisf.App.Serving;

namespace Msisf.Server;

/// <summary>What the first message of a stream says.</summary>
/// <param name="Frame">Options of all images.</param>
/// <param name="Cameras">The cameras; a stream of one camera has one without options of its own.</param>
/// <param name="Form">Form of the images.</param>
/// <param name="IsNewestOnly">Whether states are left out that are older than another one that waits.</param>
/// <param name="IsTimed">Whether the times of each image are reported.</param>
internal sealed record StreamOpening(
    JsonElement Frame, IReadOnlyList<StreamCamera> Cameras, AnswerForm Form, bool IsNewestOnly, bool IsTimed)
{
    public static StreamOpening Read(JsonElement message)
    {
        IReadOnlyDictionary<string, JsonElement> members = JsonText.Members(message);
        if (members.Keys.FirstOrDefault(key => key is not ("frame" or "cameras" or "mode" or "format" or "timing")) is { } unknown)
        {
            throw new UsageException(
                $"'{unknown}' is not known here; the first message has 'frame', 'cameras', 'mode', 'format' and 'timing'.");
        }

        bool isNewestOnly = WordOf(members, "mode", "lock-step", "newest-only") == "newest-only";
        AnswerForm form = WordOf(members, "format", "u8", "png", "u8+layers") switch
        {
            "png" => AnswerForm.Of(AnswerForm.Png),
            "u8+layers" => AnswerForm.LevelsAndLayers,
            _ => AnswerForm.Of(AnswerForm.Raw),
        };
        bool isTimed = FlagOf(members, "timing");
        return new StreamOpening(FrameOf(members), CamerasOf(members), form, isNewestOnly, isTimed);
    }

    private static JsonElement FrameOf(IReadOnlyDictionary<string, JsonElement> members) =>
        members.TryGetValue("frame", out JsonElement frame)
            ? frame
            : throw new UsageException("the first message has no 'frame', the options of the images.");

    private static IReadOnlyList<StreamCamera> CamerasOf(IReadOnlyDictionary<string, JsonElement> members) =>
        members.TryGetValue("cameras", out JsonElement cameras)
            ? StreamCamera.Read(cameras, FrameOf(members))
            : [new StreamCamera(new Dictionary<string, JsonElement>(), Rig: null)];

    private static bool FlagOf(IReadOnlyDictionary<string, JsonElement> members, string name) =>
        members.TryGetValue(name, out JsonElement value)
        && value.ValueKind switch
        {
            JsonValueKind.True => true,
            JsonValueKind.False => false,
            _ => throw new UsageException($"'{name}' is {JsonText.Shown(value)}; true or false is needed."),
        };

    private static string WordOf(IReadOnlyDictionary<string, JsonElement> members, string name, params string[] words)
    {
        string word = members.TryGetValue(name, out JsonElement value) ? JsonText.Of(value, $"'{name}'") : words[0];
        return words.Contains(word)
            ? word
            : throw new UsageException($"'{name}' is '{word}'; one of {string.Join(", ", words)} is needed.");
    }
}
