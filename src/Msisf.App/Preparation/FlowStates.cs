using Msisf.Adapters.Input;
using Msisf.Adapters.Metadata;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Scene;
using Msisf.Core.Time;

namespace Msisf.App.Preparation;

/// <summary>Says for each state of a run to which other state its flow leads.</summary>
internal static class FlowStates
{
    /// <summary>The options that say what an image looks like from a state.</summary>
    private static readonly OptionSpec[] OfImage =
        [ImageOptions.Camera, ImageOptions.FieldOfView, ImageOptions.Width, ImageOptions.Height];

    /// <summary>
    /// The states with those of their flows. The first has no state before it, the last none behind it or, of an odd number, none to pair
    /// with.
    /// </summary>
    /// <exception cref="MsisfException">The target can't be read, or its image is another one.</exception>
    public static IReadOnlyList<SpacecraftState> Of(IReadOnlyList<SpacecraftState> states, RenderSettings settings)
    {
        RefuseMovingRows(states, settings);
        if (settings.Native.Navigation?.Flow is not { } target)
        {
            return states;
        }

        Func<int, int>? other = target switch
        {
            NavigationOptions.NextFrame => index => index + 1,
            NavigationOptions.PreviousFrame => index => index - 1,
            NavigationOptions.PairedFrame => index => index ^ 1,
            _ => null,
        };
        if (other is null)
        {
            FlowState only = NavigationOptions.Flow.NamedInErrors(() => Read(target, settings, states[0].Time.Scale));
            return [.. states.Select(state => state with { Flow = only })];
        }

        if (states.Count < 2)
        {
            throw NavigationOptions.Flow.Wrong(
                $"{target} leads to another image of the run, but that has one only. Name a meta file or a state, or give more states.");
        }

        return [.. states.Select((state, index) => other(index) >= 0 && other(index) < states.Count
            ? state with { Flow = FlowState.Of(states[other(index)]) }
            : state)];
    }

    /// <summary>Rows with states of their own have no other image to which a flow leads, nor one beside them.</summary>
    private static void RefuseMovingRows(IReadOnlyList<SpacecraftState> states, RenderSettings settings)
    {
        OptionSpec? option = settings.Native.Navigation switch
        {
            { Flow: not null } => NavigationOptions.Flow,
            { Stereo: not null } => NavigationOptions.Stereo,
            _ => null,
        };
        if (option is null)
        {
            return;
        }

        bool rolls = settings.Native.Detector?.Settings.Shutter is { IsRolling: true }
            && states.Any(state => state.Motion is { IsRest: false } || state.Path is not null);
        if (settings.Scan is not null || rolls)
        {
            string why = rolls ? "the shutter of this one rolls while it moves" : "this one scans";
            string change = rolls ? "give the camera file a global 'shutter'" : "remove 'scan' from the camera file";
            throw option.Wrong(
                $"needs a camera whose rows are all taken at once, and {why}. Leave it out, or {change}.", ImageOptions.Camera);
        }
    }

    private static FlowState Read(string target, RenderSettings settings, TimeScale scale)
    {
        if (target.StartsWith('{'))
        {
            return StateOf(target, scale);
        }

        if (!File.Exists(target))
        {
            throw new BadInputException(
                $"{target}: there is no such file. Give next, previous, pair, a meta file or a state {{MJD,rx,ry,rz,qx,qy,qz,q0}}.");
        }

        IReadOnlyList<string> words = MetaFileOrigin.Command(target)
            ?? throw new BadInputException($"{target}: no meta file, or it does not say what made it. Give the .xml file of an image.");
        int at = words.ToList().IndexOf(CameraOptions.FixedState.Name);
        if (at < 0 || at + 1 >= words.Count)
        {
            throw new BadInputException($"{target}: its command line names no state. Give the .xml file of an image.");
        }

        string[] own = FrameArguments.OfSettings(settings, engine: null).Split(' ', StringSplitOptions.RemoveEmptyEntries);
        foreach (OptionSpec option in OfImage)
        {
            (string? there, string? here) = (ValueOf(words, option), ValueOf(own, option)?.Trim('\''));
            if (there != here)
            {
                throw new BadInputException(
                    $"{target}: its image was made with {option.Name} {there ?? "left out"}, this one with {here ?? "none"}. A flow needs "
                        + "two images of the same size and camera.");
            }
        }

        FlowState state = StateOf(words[at + 1], scale);
        return ValueOf(words, LightOptions.SunPosition) is { } sun
            ? FlowState.FromNumbers(
                state.Time,
                [.. state.ToNumbers().Skip(1), .. StateText.ParseNumbers(NavigationOptions.Flow.Name, [sun], FlowState.NumberNamesOfSun)])
            : state;
    }

    private static FlowState StateOf(string text, TimeScale scale)
    {
        bool hasSun = text.Count(letter => letter == ',') + 1 == FlowState.NumberNamesWithSun.Count;
        (CalendarTime time, double[] numbers) = StateText.ParseState(
            NavigationOptions.Flow.Name, [text], hasSun ? FlowState.NumberNamesWithSun : SpacecraftState.NumberNames);
        return FlowState.FromNumbers(scale.InstantOf(time), numbers);
    }

    private static string? ValueOf(IReadOnlyList<string> words, OptionSpec option)
    {
        for (int i = 0; i + 1 < words.Count; i++)
        {
            if (words[i] == option.Name)
            {
                return words[i + 1];
            }
        }

        return null;
    }
}
