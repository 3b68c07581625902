using Msisf.Core.Errors;
using Msisf.Core.Sensitivity;
using Xunit;

namespace Msisf.Core.Tests.Sensitivity;

public sealed class FisherInformationTests
{
    /// <summary>1: an inverse of a few numbers.</summary>
    private const double Rounding = 1e-12;

    /// <summary>
    /// Two pixels of variance 4 with derivatives (1, 1) and (1, -2): F = [[0.5, -0.25], [-0.25, 1.25]], whose determinant is 9/16; so the
    /// covariance is [[20, 4], [4, 8]] / 9.
    /// </summary>
    [Fact]
    public void Of_TwoPixels_HasTheInverseOfTheirSum()
    {
        IReadOnlyList<Parameter> parameters = Parameter.ParseList("turn-x,turn-y");

        FisherInformation found = FisherInformation.Of(parameters, [[1.0, 1.0], [1.0, -2.0]], [4.0, 4.0]);

        Assert.Equal(2, found.Rank);
        Assert.Equal(-0.25, found.Matrix[0, 1], Rounding);
        Assert.Equal(20.0 / 9.0, found.Covariance[0, 0]!.Value, Rounding);
        Assert.Equal(4.0 / 9.0, found.Covariance[0, 1]!.Value, Rounding);
        Assert.Equal(Math.Sqrt(8.0 / 9.0), found.DeviationOf(parameters[1])!.Value, Rounding);
    }

    [Fact]
    public void Of_ParametersThatActAlike_HasNoBoundOfThem()
    {
        IReadOnlyList<Parameter> parameters = Parameter.ParseList("position-y,turn-z,albedo");

        FisherInformation found = FisherInformation.Of(
            parameters, [[1e-3, 2e-3, -1e-3], [100.0, 200.0, -100.0], [1.0, 1.0, 1.0]], [1.0, 1.0, 1.0]);

        Assert.Equal(2, found.Rank);
        Assert.Null(found.DeviationOf(parameters[0]));
        Assert.Null(found.DeviationOf(parameters[1]));
        Assert.NotNull(found.DeviationOf(parameters[2]));
        Assert.Equal(-1e-5, found.Weakest[1] / found.Weakest[0], Rounding);
    }

    [Fact]
    public void Of_NoLight_TellsNothing()
    {
        double[][] nothing = [.. Parameter.Pose.Select(_ => new double[4])];

        FisherInformation found = FisherInformation.Of(Parameter.Pose, nothing, [1.0, 1.0, 1.0, 1.0]);

        Assert.Equal(0, found.Rank);
        Assert.All(Parameter.Pose, parameter => Assert.Null(found.DeviationOf(parameter)));
        Assert.Empty(found.AxesOf(ParameterKind.Position));
        Assert.All(found.Weakest, part => Assert.True(double.IsFinite(part)));
    }

    [Fact]
    public void Of_SaturatedPixel_TellsNothing()
    {
        IReadOnlyList<Parameter> albedo = Parameter.ParseList("albedo");

        FisherInformation found = FisherInformation.Of(albedo, [[3.0, 5.0]], [9.0, double.PositiveInfinity]);

        Assert.Equal(1.0, found.Matrix[0, 0], Rounding);
    }

    [Theory]
    [InlineData("turn-q", "turn-q")]
    [InlineData("albedo,albedo", "twice")]
    [InlineData("", "''")]
    public void ParseList_WrongText_SaysWhat(string text, string part) =>
        Assert.Contains(part, Assert.Throws<UsageException>(() => Parameter.ParseList(text)).Message);

    [Fact]
    public void ParseList_AnyOrder_IsThatOfFiles() =>
        Assert.Equal(["position-x", "turn-z", "albedo"], Parameter.ParseList("albedo, TURN-Z,position-x").Select(p => p.Name));
}
