using Xunit;

namespace Msisf.Stress.Tests;

/// <summary>On a desk the test is skipped, by the names of the missing parts; with CI=true it runs and fails.</summary>
[AttributeUsage(AttributeTargets.Method)]
internal sealed class MissingPartsFactAttribute : FactAttribute
{
    public MissingPartsFactAttribute()
    {
        string[] missing = [.. StressTests.All.Where(test => test.MissingPart is not null).Select(
            test => $"{test.MissingPart} for {test.Name}")];
        if (missing.Length > 0 && Environment.GetEnvironmentVariable("CI") != "true")
        {
            Skip = $"missing: {string.Join(", ", missing)}";
        }
    }
}
