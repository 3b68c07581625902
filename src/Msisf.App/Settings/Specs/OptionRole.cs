namespace Msisf.App.Settings.Specs;

/// <summary>
/// What an option decides: the bytes of the outputs (<see cref="DecidesBytes"/>), where and how they are made, or what is printed.
/// </summary>
internal class OptionRole
{
    /// <summary>Where and how the outputs are made; their bytes are the same with any value.</summary>
    public static readonly OptionRole HowItRuns = new();

    /// <summary>What is printed or measured; the outputs are the same.</summary>
    public static readonly OptionRole WhatIsPrinted = new();

    protected OptionRole()
    {
    }
}
